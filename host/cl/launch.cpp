// Launching kernels: argument checks, work-group sizes, profiling, and the time of code generation kept apart.
#include <algorithm>
#include <chrono>

#include "cl/cl_error.h"
#include "cl/program.h"
#include "util/error.h"

namespace pencil {
namespace {

// Measured on PoCL 3.1: 65528 work-items share code with smaller grids, 65536 do not.
constexpr std::size_t large_grid = 65535;

std::size_t rounded_up(std::size_t count, std::size_t step) { return (count + step - 1) / step * step; }

std::string range_text(const cl::NDRange& range) {
    const std::size_t* sizes = range.get();
    return range.dimensions() == 2 ? std::to_string(sizes[0]) + "x" + std::to_string(sizes[1]) : std::to_string(sizes[0]);
}

}  // namespace

Launch::Launch(std::shared_ptr<Device> device, cl::Kernel kernel, std::string name, std::shared_ptr<CompiledKernel> compiled)
    : device_(std::move(device)), kernel_(std::move(kernel)), name_(std::move(name)), compiled_(std::move(compiled)) {
    cl_call([&] { return "reading the limits of kernel " + name_; },
            [&] {
                argument_count_ = kernel_.getInfo<CL_KERNEL_NUM_ARGS>();
                const auto required = kernel_.getWorkGroupInfo<CL_KERNEL_COMPILE_WORK_GROUP_SIZE>(device_->cl_device());
                required_x_ = required[0];
                required_y_ = required[1];
                max_group_ = kernel_.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(device_->cl_device());
            });
    max_group_ = std::max<std::size_t>(std::min(max_group_, device_->info().max_work_group), 1);
}

void Launch::set_memory(unsigned index, const cl::Memory& memory, const char* kind) {
    if (index >= argument_count_) return;  // check_argument_count reports it
    cl_call([&] { return "setting argument " + std::to_string(index) + " (" + kind + ") of kernel " + name_; },
            [&] { kernel_.setArg(index, sizeof(cl_mem), &memory()); });
}

void Launch::set_value(unsigned index, const void* value, std::size_t bytes) {
    if (index >= argument_count_) return;
    cl_call(
        [&] {
            return "setting argument " + std::to_string(index) + " (a value of " + std::to_string(bytes) + " bytes) of kernel " + name_;
        },
        [&] { kernel_.setArg(index, bytes, value); });
}

void Launch::check_argument_count(unsigned count) {
    if (count == argument_count_) return;
    throw DeviceError("kernel " + name_ + " takes " + std::to_string(argument_count_) + " arguments and was given " +
                      std::to_string(count));
}

void Launch::run(std::size_t global, const std::string& description, std::size_t local) {
    if (global == 0) return;
    if (local == 0) local = required_x_ != 0 ? required_x_ : device_->local_size(name_);
    const std::size_t group = std::min(local, max_group_);
    check_group(group, 1);
    enqueue(cl::NDRange(rounded_up(global, group)), cl::NDRange(group), description);
}

void Launch::make_code(std::size_t items) {
    if (compiled_->parameters.size() != argument_count_) return;
    for (const KernelParameter& parameter : compiled_->parameters)
        if (parameter.type.rfind("image", 0) == 0) return;  // PoCL reads what an image is before a kernel can test its bounds
    constexpr std::size_t largest_value = 1024;
    const std::vector<char> zeros(largest_value, 0);
    for (unsigned i = 0; i < argument_count_; ++i) {
        if (compiled_->parameters[i].buffer) {
            kernel_.setArg(i, sizeof(cl_mem), nullptr);
            continue;
        }
        // A driver refuses values of another size than the parameter's, and nothing else tells that size.
        std::size_t bytes = 1;
        while (bytes <= largest_value && clSetKernelArg(kernel_(), i, bytes, zeros.data()) != CL_SUCCESS) bytes += bytes < 4 ? bytes : 4;
        if (bytes > largest_value) return;
    }
    run(items, "nothing, to have code made");
}

void Launch::run2d(std::size_t global_x, std::size_t global_y, std::size_t local_x, std::size_t local_y, const std::string& description) {
    if (global_x == 0 || global_y == 0) return;
    local_x = std::min(std::max<std::size_t>(local_x, 1), max_group_);
    local_y = std::min(std::max<std::size_t>(local_y, 1), std::max<std::size_t>(max_group_ / local_x, 1));
    check_group(local_x, local_y);
    enqueue(cl::NDRange(rounded_up(global_x, local_x), rounded_up(global_y, local_y)), cl::NDRange(local_x, local_y), description);
}

// A kernel that was written for one group size would leave its buffers with another.
void Launch::check_group(std::size_t local_x, std::size_t local_y) const {
    if (required_x_ == 0 || (local_x == required_x_ && local_y == required_y_)) return;
    throw DeviceError("kernel " + name_ + " needs groups of " + std::to_string(required_x_) + "x" + std::to_string(required_y_) +
                      " work-items and would get " + std::to_string(local_x) + "x" + std::to_string(local_y) + "; " + device_->info().name +
                      " allows " + std::to_string(max_group_) + " per group for it");
}

void Launch::enqueue(const cl::NDRange& global, const cl::NDRange& local, const std::string& description) {
    const auto doing = [&] {
        return "launching \"" + description + "\" (kernel " + name_ + ", " + range_text(global) + " work-items in groups of " +
               range_text(local) + ") on " + device_->info().name;
    };
    // PoCL generates code at the first launch of each local size, and again for grids of 65535 items or more. Such a launch runs alone, so
    // that the time beyond its own run counts as build time.
    const std::size_t global_y = global.dimensions() == 2 ? global.get()[1] : 0, local_y = local.dimensions() == 2 ? local.get()[1] : 0;
    const bool large = std::max(global.get()[0], global_y) >= large_grid;
    const bool first = compiled_->sizes.emplace(local.get()[0], local_y, large).second;
    cl_call(doing, [&] {
        device_->launch_may_fail();
        if (first) device_->queue().finish();
        const auto start = std::chrono::steady_clock::now();
        cl::Event event;
        device_->queue().enqueueNDRangeKernel(kernel_, cl::NullRange, global, local, nullptr, &event);
        if (first) {
            device_->queue().finish();
            const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            // A driver that measures no times would have all of them counted as building.
            if (const double running = event_seconds(event); running > 0) device_->add_build_seconds(std::max(wall - running, 0.0));
        }
        device_->record(description, name_, event);
    });
}

}  // namespace pencil
