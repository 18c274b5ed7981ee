#include "cl/kernel_parameters.h"

#include <fmt/format.h>

#include "util/error.h"

namespace pencil {

namespace {

std::string spelled(const std::string& type, bool buffer) {
    return buffer ? fmt::format("a buffer of {}", type) : fmt::format("a {}", type);
}

/// "Triangle" of "Triangle*".
std::string element(std::string type) {
    while (!type.empty() && (type.back() == '*' || type.back() == ' ')) type.pop_back();
    return type;
}

}  // namespace

std::vector<KernelParameter> read_parameters(const cl::Kernel& kernel) {
    std::vector<KernelParameter> parameters;
    try {
        const unsigned count = kernel.getInfo<CL_KERNEL_NUM_ARGS>();
        for (unsigned i = 0; i < count; ++i) {
            const auto space = kernel.getArgInfo<CL_KERNEL_ARG_ADDRESS_QUALIFIER>(i);
            const std::string type = element(kernel.getArgInfo<CL_KERNEL_ARG_TYPE_NAME>(i).c_str());
            // Drivers disagree about the address space of images.
            const bool image = type.rfind("image", 0) == 0;
            parameters.push_back({std::string(kernel.getArgInfo<CL_KERNEL_ARG_NAME>(i).c_str()), type,
                                  image || space == CL_KERNEL_ARG_ADDRESS_GLOBAL || space == CL_KERNEL_ARG_ADDRESS_CONSTANT});
        }
    } catch (const cl::Error&) {
        return {};
    }
    return parameters;
}

void check_argument(const std::string& kernel, const std::vector<KernelParameter>& parameters, unsigned index, const char* type,
                    bool buffer) {
    if (index >= parameters.size()) return;  // the number is checked on its own
    const KernelParameter& wanted = parameters[index];
    if (wanted.buffer == buffer && (!type || wanted.type == type)) return;
    throw DeviceError(fmt::format("argument {} of kernel {}, \"{}\", is {} and was given {}", index, kernel, wanted.name,
                                  spelled(wanted.type, wanted.buffer), spelled(type ? type : "another type", buffer)));
}

}  // namespace pencil
