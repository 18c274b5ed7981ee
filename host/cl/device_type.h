// Names of host types in OpenCL C, for the check of kernel arguments. Structs of kernels/shared name themselves (PENCIL_SHARED_TYPE).
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "shared/types.h"

namespace pencil {

PENCIL_DEVICE_TYPE(float, "float")
PENCIL_DEVICE_TYPE(double, "double")
PENCIL_DEVICE_TYPE(int, "int")
PENCIL_DEVICE_TYPE(uint, "uint")
PENCIL_DEVICE_TYPE(unsigned char, "uchar")
PENCIL_DEVICE_TYPE(unsigned short, "ushort")
PENCIL_DEVICE_TYPE(std::uint64_t, "half")  // four of them
PENCIL_DEVICE_TYPE(glm::vec2, "float2")
PENCIL_DEVICE_TYPE(glm::vec4, "float4")
PENCIL_DEVICE_TYPE(glm::ivec2, "int2")
PENCIL_DEVICE_TYPE(glm::ivec4, "int4")
PENCIL_DEVICE_TYPE(glm::uvec2, "uint2")

}  // namespace pencil
