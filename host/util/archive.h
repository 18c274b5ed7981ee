// Values as a row of bytes and back, in this machine's byte order. One function `transfer(Archive&)` of a class names its values once, for both
// directions. What is read may be anything: no size is believed before as many bytes are there.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pencil {

/// Bytes that cannot be what they are read as.
struct ArchiveError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Archive {
public:
    /// Writes.
    Archive() = default;
    /// Reads.
    explicit Archive(std::vector<char> bytes) : reads_(true), bytes_(std::move(bytes)) {}

    bool reads() const { return reads_; }
    std::size_t remaining() const { return bytes_.size() - next_; }
    std::vector<char> take() { return std::move(bytes_); }

    /// Writes the values, or replaces them by what is read; ArchiveError.
    template <typename... Values>
    void operator()(Values&... values) {
        (transfer(values), ...);
    }

    /// ArchiveError unless so.
    static void expect(bool so, const char* what) {
        if (!so) throw ArchiveError(what);
    }

private:
    template <typename T, typename = void>
    struct HasTransfer : std::false_type {};
    template <typename T>
    struct HasTransfer<T, std::void_t<decltype(std::declval<T&>().transfer(std::declval<Archive&>()))>> : std::true_type {};

    void raw(void* data, std::size_t size) {
        if (!reads_) {
            const char* from = static_cast<const char*>(data);
            bytes_.insert(bytes_.end(), from, from + size);
            return;
        }
        expect(size <= remaining(), "it ends too early");
        if (size > 0) std::memcpy(data, bytes_.data() + next_, size);
        next_ += size;
    }

    template <typename T>
    void transfer(T& value) {
        if constexpr (HasTransfer<T>::value) {
            value.transfer(*this);
        } else {
            static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>, "say how to transfer it");
            raw(&value, sizeof(T));
        }
    }
    void transfer(bool& value) {
        auto byte = static_cast<unsigned char>(value);
        raw(&byte, 1);
        value = byte != 0;
    }
    template <typename T, std::size_t n>
    void transfer(std::array<T, n>& values) {
        for (T& value : values) transfer(value);
    }
    void transfer(std::string& text) {
        text.resize(size_of(text.size(), 1));
        raw(text.data(), text.size());
    }
    template <typename A, typename B>
    void transfer(std::pair<A, B>& pair) {
        (*this)(pair.first, pair.second);
    }
    template <typename T>
    void transfer(std::vector<T>& values) {
        constexpr bool flat = std::is_trivially_copyable_v<T> && !HasTransfer<T>::value;
        values.resize(size_of(values.size(), flat ? sizeof(T) : 1));
        if constexpr (flat)
            raw(values.data(), values.size() * sizeof(T));
        else
            for (T& value : values) transfer(value);
    }

    /// Of a list whose values take so many `bytes` each at least.
    std::size_t size_of(std::size_t size, std::size_t bytes) {
        auto count = static_cast<std::uint64_t>(size);
        raw(&count, sizeof(count));
        if (reads_) expect(count <= remaining() / bytes, "a list is longer than the rest");
        return static_cast<std::size_t>(count);
    }

    bool reads_ = false;
    std::vector<char> bytes_;
    std::size_t next_ = 0;
};

}  // namespace pencil
