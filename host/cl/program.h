// Kernels by name: programs specialised by defines, built once per device.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "cl/buffer.h"
#include "cl/device.h"
#include "cl/device_type.h"
#include "cl/kernel_parameters.h"
#include "cl/program_binaries.h"
#include "cl/texel_image.h"

namespace pencil {

using Defines = std::map<std::string, std::string>;  // PENCIL_X -> value

/// What is known of a kernel that was built.
struct CompiledKernel {
    std::vector<KernelParameter> parameters;
    /// Local sizes (x, y or 0) that it was launched with, and whether the grid was large: what PoCL generates code for.
    std::set<std::tuple<std::size_t, std::size_t, bool>> sizes;
};

template <typename T>
struct IsGroup : std::false_type {};
template <typename... T>
struct IsGroup<std::tuple<T...>> : std::true_type {};

/// A kernel bound to its arguments; `run` launches it. Global sizes are rounded up to the local size: kernels test their bounds.
class Launch {
public:
    Launch(std::shared_ptr<Device> device, cl::Kernel kernel, std::string name,
           std::shared_ptr<CompiledKernel> compiled = std::make_shared<CompiledKernel>());

    /// Buffers, images, values, and groups of them (tuples) that travel together, in the order of the kernel's parameters. DeviceError if number,
    /// type or address space differ from what the kernel declares.
    template <typename... Args>
    Launch& args(const Args&... values) {
        given_ = 0;
        (add(values), ...);
        check_argument_count(given_);
        return *this;
    }
    /// 1-D; `local` 0: the size the kernel requires (reqd_work_group_size), else the device's local_size(kernel). Larger local sizes than the
    /// kernel allows on this device are reduced, except required ones: those are a DeviceError. `description` is the profiling key and
    /// stands in error messages.
    void run(std::size_t global, const std::string& description, std::size_t local = 0);
    /// 2-D with local size (local_x, local_y).
    void run2d(std::size_t global_x, std::size_t global_y, std::size_t local_x, std::size_t local_y, const std::string& description);

    /// Has the driver make the code for `items` work-items, and launches that many with zeros and null buffers: kernels test their bounds, but
    /// only a process that may die should rely on it. Nothing happens where the driver does not say what the parameters are.
    void make_code(std::size_t items);

    /// Work-items per group that the device allows this kernel.
    std::size_t max_group() const { return max_group_; }

private:
    template <typename T>
    void add(const Buffer<T>& buffer) {
        check_argument(name_, compiled_->parameters, given_, DeviceType<T>::name, true);
        set_memory(given_++, buffer.handle(), "a buffer");
    }
    void add(const TexelImage& image) {
        check_argument(name_, compiled_->parameters, given_, "image2d_array_t", true);
        set_memory(given_++, image.handle(), "an image");
    }
    template <typename T>
    void add(const T& value) {
        if constexpr (IsGroup<T>::value) {
            std::apply([this](const auto&... members) { (add(members), ...); }, value);
        } else {
            static_assert(std::is_trivially_copyable_v<T>, "a kernel takes plain data by value");
            check_argument(name_, compiled_->parameters, given_, DeviceType<T>::name, false);
            set_value(given_++, &value, sizeof(T));
        }
    }
    void set_memory(unsigned index, const cl::Memory& memory, const char* kind);
    void set_value(unsigned index, const void* value, std::size_t bytes);
    void check_argument_count(unsigned count);
    void check_group(std::size_t local_x, std::size_t local_y) const;
    void enqueue(const cl::NDRange& global, const cl::NDRange& local, const std::string& description);

    std::shared_ptr<Device> device_;
    cl::Kernel kernel_;
    std::string name_;
    std::shared_ptr<CompiledKernel> compiled_;
    unsigned argument_count_ = 0, given_ = 0;
    std::size_t max_group_ = 1;
    std::size_t required_x_ = 0, required_y_ = 0;  // reqd_work_group_size, 0 if none
};

class ProgramCache {
public:
    explicit ProgramCache(std::shared_ptr<Device> device) : device_(std::move(device)), binaries_(device_->info()) {}

    /// The kernel `name` of the program `file` (kernel_source.h) with `defines`. Builds at first use: -cl-std=CL1.2 -Werror, no fast-math;
    /// a build failure is a DeviceError with device, options and the whole log. PENCIL_WIDTH is always defined.
    /// Defines that the program does not name are left out: it is the same program without them.
    Launch kernel(const std::string& name, const std::string& file, const Defines& defines = {});

    const std::shared_ptr<Device>& device() const { return device_; }
    /// Names of the kernels built so far, for --explain and --stats.
    std::vector<std::string> built() const;

private:
    const Defines& used(const std::string& file, const Defines& defines);
    cl::Program build(const std::string& file, const Defines& defines);
    cl::Program build_binary(const ProgramBinaries::Binary& binary, const std::string& options) const;
    cl::Program build_source(const std::string& file, const std::string& source, const std::string& options) const;
    std::shared_ptr<Device> device_;
    ProgramBinaries binaries_;
    std::map<std::string, cl::Program> programs_;
    std::map<std::string, Defines> used_;                              // by file and all defines that were given
    std::map<std::string, std::shared_ptr<CompiledKernel>> compiled_;  // by program and kernel name
};

}  // namespace pencil
