// Device memory: reserved in the plan first, then allocated, given back on destruction.
#include "cl/buffer.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

#include "cl/cl_error.h"
#include "util/error.h"

namespace pencil {
namespace {

// OpenCL refuses empty buffers; an empty list is an ordinary case (a scene without emitters).
std::size_t allocated_bytes(std::size_t bytes) { return std::max<std::size_t>(bytes, 1); }

}  // namespace

BufferStorage::BufferStorage(std::shared_ptr<Device> device, std::size_t bytes, const std::string& what)
    : device_(std::move(device)), bytes_(bytes), what_(what) {
    device_->reserve(allocated_bytes(bytes_), what_);
    try {
        buffer_ = cl_call([&] { return "allocating " + format_bytes(bytes_) + " for " + what_ + " on " + device_->info().name; },
                          [&] {
                              device_->allocation_may_fail();
                              return cl::Buffer(device_->context(), CL_MEM_READ_WRITE, allocated_bytes(bytes_));
                          });
    } catch (...) {
        device_->release(allocated_bytes(bytes_));
        throw;
    }
}

BufferStorage::~BufferStorage() {
    if (device_) device_->release(allocated_bytes(bytes_));
}

BufferStorage::BufferStorage(BufferStorage&& other) noexcept
    : device_(std::move(other.device_)), bytes_(other.bytes_), what_(std::move(other.what_)), buffer_(std::move(other.buffer_)) {
    other.device_.reset();
    other.bytes_ = 0;
}

BufferStorage& BufferStorage::operator=(BufferStorage&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(bytes_, other.bytes_);
    std::swap(what_, other.what_);
    std::swap(buffer_, other.buffer_);
    return *this;
}

void BufferStorage::check_range(const char* verb, std::size_t offset, std::size_t bytes) const {
    if (offset <= bytes_ && bytes <= bytes_ - offset) return;
    throw std::out_of_range(std::string(verb) + " " + std::to_string(bytes) + " bytes at offset " + std::to_string(offset) + " of " +
                            what_ + ", which has " + std::to_string(bytes_) + " bytes");
}

void BufferStorage::read(void* to, std::size_t offset, std::size_t bytes) const {
    check_range("reading", offset, bytes);
    if (bytes == 0) return;
    cl_call([&] { return "reading " + format_bytes(bytes) + " of " + what_ + " from " + device_->info().name; },
            [&] { device_->queue().enqueueReadBuffer(buffer_, CL_TRUE, offset, bytes, to); });
}

void BufferStorage::read_rows(void* to, std::size_t offset, std::size_t pitch, std::size_t rows, std::size_t row_bytes) const {
    if (row_bytes > pitch) throw std::out_of_range("rows of " + what_ + " overlap");
    check_range("reading", offset, (rows - 1) * pitch + row_bytes);
    const std::array<cl::size_type, 3> from{offset % pitch, offset / pitch, 0}, target{0, 0, 0}, size{row_bytes, rows, 1};
    cl_call([&] { return "reading " + format_bytes(rows * row_bytes) + " of " + what_ + " from " + device_->info().name; },
            [&] { device_->queue().enqueueReadBufferRect(buffer_, CL_TRUE, from, target, size, pitch, 0, row_bytes, 0, to); });
}

void BufferStorage::write(const void* from, std::size_t offset, std::size_t bytes) {
    check_range("writing", offset, bytes);
    if (bytes == 0) return;
    cl_call([&] { return "writing " + format_bytes(bytes) + " of " + what_ + " to " + device_->info().name; },
            [&] { device_->queue().enqueueWriteBuffer(buffer_, CL_TRUE, offset, bytes, from); });
}

void BufferStorage::fill_zero() {
    if (bytes_ == 0) return;
    cl_call([&] { return "clearing " + what_ + " (" + format_bytes(bytes_) + ") on " + device_->info().name; },
            [&] {
                // PoCL stores one pattern after the other.
                if (bytes_ % sizeof(cl_ulong16) == 0)
                    device_->queue().enqueueFillBuffer(buffer_, cl_ulong16{}, 0, bytes_);
                else if (bytes_ % sizeof(cl_uint) == 0)
                    device_->queue().enqueueFillBuffer(buffer_, cl_uint{0}, 0, bytes_);
                else
                    device_->queue().enqueueFillBuffer(buffer_, cl_uchar{0}, 0, bytes_);
            });
}

void BufferStorage::copy_from(const BufferStorage& other, std::size_t source, std::size_t target, std::size_t bytes) {
    other.check_range("copying", source, bytes);
    check_range("copying to", target, bytes);
    if (bytes == 0) return;
    cl_call([&] { return "copying " + other.what_ + " to " + what_ + " on " + device_->info().name; },
            [&] { device_->queue().enqueueCopyBuffer(other.buffer_, buffer_, source, target, bytes); });
}

std::size_t checked_bytes(std::size_t count, std::size_t size, const std::string& what) {
    if (count > std::numeric_limits<std::size_t>::max() / size)
        throw MemoryError(what + ": " + std::to_string(count) + " elements of " + std::to_string(size) + " bytes exceed the address space");
    return count * size;
}

void throw_unallocated_buffer() { throw std::logic_error("a Buffer without storage was used; give it a device and a size first"); }

}  // namespace pencil
