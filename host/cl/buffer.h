// Typed device memory, counted against the device's plan. Reads and writes block; sizes are checked.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cl/device.h"

namespace pencil {

/// Untyped part: owns the cl::Buffer and the reservation. Zero bytes are allowed (one byte is allocated).
class BufferStorage {
public:
    BufferStorage(std::shared_ptr<Device> device, std::size_t bytes, const std::string& what);
    ~BufferStorage();
    BufferStorage(BufferStorage&& other) noexcept;
    BufferStorage& operator=(BufferStorage&& other) noexcept;
    void read(void* to, std::size_t offset, std::size_t bytes) const;
    void read_rows(void* to, std::size_t offset, std::size_t pitch, std::size_t rows, std::size_t row_bytes) const;
    void write(const void* from, std::size_t offset, std::size_t bytes);
    void fill_zero();
    void copy_from(const BufferStorage& other, std::size_t source, std::size_t target, std::size_t bytes);
    const cl::Buffer& handle() const { return buffer_; }
    const std::string& what() const { return what_; }

private:
    void check_range(const char* verb, std::size_t offset, std::size_t bytes) const;
    std::shared_ptr<Device> device_;
    std::size_t bytes_ = 0;
    std::string what_;
    cl::Buffer buffer_;
};

[[noreturn]] void throw_unallocated_buffer();
/// count * size; MemoryError where that overflows.
std::size_t checked_bytes(std::size_t count, std::size_t size, const std::string& what);

template <typename T>
class Buffer {
public:
    Buffer() = default;
    /// `what` names the contents in error messages ("pencil radiance atlas").
    Buffer(std::shared_ptr<Device> device, std::size_t count, const std::string& what)
        : storage_(std::make_unique<BufferStorage>(std::move(device), checked_bytes(count, sizeof(T), what), what)), count_(count) {}
    Buffer(std::shared_ptr<Device> device, const std::vector<T>& data, const std::string& what)
        : Buffer(std::move(device), data.size(), what) {
        write(data);
    }

    std::size_t size() const { return count_; }
    bool empty() const { return count_ == 0; }
    bool allocated() const { return storage_ != nullptr; }
    const cl::Buffer& handle() const { return storage().handle(); }

    void write(const std::vector<T>& data, std::size_t first = 0) {
        if (!data.empty()) storage().write(data.data(), first * sizeof(T), data.size() * sizeof(T));
    }
    /// All elements, from memory of another type.
    void write_raw(const void* data) {
        if (count_ > 0) storage().write(data, 0, count_ * sizeof(T));
    }
    std::vector<T> read(std::size_t first, std::size_t count) const {
        std::vector<T> out(count);
        if (count > 0) storage().read(out.data(), first * sizeof(T), count * sizeof(T));
        return out;
    }
    std::vector<T> read() const { return read(0, count_); }
    /// Elements first .. first + count of each of `rows` rows that lie `pitch` elements apart, in one transfer; rows one after the other.
    std::vector<T> read_rows(std::size_t first, std::size_t pitch, std::size_t rows, std::size_t count) const {
        std::vector<T> out(rows * count);
        if (!out.empty()) storage().read_rows(out.data(), first * sizeof(T), pitch * sizeof(T), rows, count * sizeof(T));
        return out;
    }
    void fill_zero() { storage().fill_zero(); }
    /// Copies elements source .. source + count of `other` to target .., on the device.
    void copy_from(const Buffer& other, std::size_t source, std::size_t target, std::size_t count) {
        storage().copy_from(other.storage(), source * sizeof(T), target * sizeof(T), count * sizeof(T));
    }

private:
    BufferStorage& storage() const {
        if (!storage_) throw_unallocated_buffer();
        return *storage_;
    }
    std::unique_ptr<BufferStorage> storage_;
    std::size_t count_ = 0;
};

}  // namespace pencil
