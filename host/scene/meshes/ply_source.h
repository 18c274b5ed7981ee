// Where the values of a PLY file come from: text lines or bytes, behind one interface, which read_ply.cpp is a template over.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>

#include "scene/meshes/ply_header.h"
#include "scene/text.h"
#include "util/error.h"

namespace pencil {

/// Numbers as text, one element per line. What programs write for the results of failed computations is NaN.
class PlyText {
public:
    PlyText(std::string_view bytes, const PlyHeader& header, const std::string& name)
        : rest_(bytes.substr(header.bytes)), name_(name), line_(header.lines), line_end_(header.line_end) {}

    static constexpr std::size_t least_bytes(PlyType) { return 2; }  // a digit and what separates it
    std::uint64_t left() const { return rest_.size() + 1; }          // the last separator may be missing
    std::uint64_t left_for_list() const { return row_.size() + 1; }
    [[noreturn]] void fail(const std::string& message) const { throw SceneError(name_ + ":" + std::to_string(line_), message); }

    void begin_row() {
        do {
            if (rest_.empty()) fail("the file ends too early");
            ++line_;
            const std::size_t end = std::min(rest_.find(line_end_), rest_.size());
            row_ = trimmed(rest_.substr(0, end));
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
        } while (row_.empty());
    }
    double read(PlyType type) {
        const std::size_t end = std::min(row_.find_first_of(" \t\r"), row_.size());
        const std::string_view word = row_.substr(0, end);
        if (word.empty()) fail("the line has too few values");
        row_ = trimmed(row_.substr(end));
        const std::optional<double> value = parse_number(word);
        if (!value && !is_integer(type) && is_no_number(word)) return std::nan("");
        if (!value) fail(number_defect(word));
        if (is_integer(type) && *value != std::floor(*value)) fail(in_quotes(word) + " is not an integer");
        return *value;
    }
    void end_row() const {
        if (!row_.empty()) fail("the line has more values than the header says: " + in_quotes(row_));
    }

private:
    std::string_view rest_, row_;
    const std::string& name_;
    std::size_t line_;
    char line_end_;
};

/// One value of type T at `bytes`, which need not be aligned.
template <class T>
double decode_ply(const unsigned char* bytes, bool swap) {
    unsigned char copy[sizeof(T)];
    std::memcpy(copy, bytes, sizeof(T));
    if (swap) std::reverse(copy, copy + sizeof(T));
    T value;
    std::memcpy(&value, copy, sizeof(T));
    return static_cast<double>(value);
}

/// Numbers as bytes in either order.
class PlyBytes {
public:
    PlyBytes(std::string_view bytes, const PlyHeader& header, const std::string& name) : bytes_(bytes), at_(header.bytes), name_(name) {
        const std::uint16_t probe = 1;
        unsigned char first = 0;
        std::memcpy(&first, &probe, 1);
        swap_ = (first == 1) != (header.encoding == PlyEncoding::little_endian);
    }

    static std::size_t least_bytes(PlyType type) { return size_of(type); }
    std::uint64_t left() const { return bytes_.size() - at_; }
    std::uint64_t left_for_list() const { return left(); }
    [[noreturn]] void fail(const std::string& message) const {
        throw SceneError(name_, message + " (at byte " + std::to_string(at_) + ")");
    }

    void begin_row() {}
    double read(PlyType type) {
        const std::size_t size = size_of(type);
        if (left() < size) fail("the file ends too early");
        const auto* bytes = reinterpret_cast<const unsigned char*>(bytes_.data()) + at_;
        at_ += size;
        switch (type) {
            case PlyType::i8:
                return decode_ply<std::int8_t>(bytes, swap_);
            case PlyType::u8:
                return decode_ply<std::uint8_t>(bytes, swap_);
            case PlyType::i16:
                return decode_ply<std::int16_t>(bytes, swap_);
            case PlyType::u16:
                return decode_ply<std::uint16_t>(bytes, swap_);
            case PlyType::i32:
                return decode_ply<std::int32_t>(bytes, swap_);
            case PlyType::u32:
                return decode_ply<std::uint32_t>(bytes, swap_);
            case PlyType::f32:
                return decode_ply<float>(bytes, swap_);
            default:
                return decode_ply<double>(bytes, swap_);
        }
    }
    void end_row() const {}

private:
    std::string_view bytes_;
    std::size_t at_;
    const std::string& name_;
    bool swap_ = false;
};

}  // namespace pencil
