// What a kernel's source declares of its parameters, and the check of arguments against it.
#pragma once

#include <string>
#include <vector>

#include "cl/opencl.h"

namespace pencil {

struct KernelParameter {
    std::string name;
    std::string type;     // "float4", "Triangle", without the star of a pointer
    bool buffer = false;  // a pointer to global or constant memory, or an image; else a value
};

/// In order; empty where the device keeps no such information: the extension of OpenCL 1.2 is optional for programs from binaries.
std::vector<KernelParameter> read_parameters(const cl::Kernel& kernel);

/// DeviceError if an argument of type `type` (nullptr: of unknown name, not compared) in a buffer or by value does not fit parameter
/// `index`.
void check_argument(const std::string& kernel, const std::vector<KernelParameter>& parameters, unsigned index, const char* type,
                    bool buffer);

}  // namespace pencil
