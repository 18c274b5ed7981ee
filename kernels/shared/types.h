// Vocabulary shared by C++17 and OpenCL C 1.2. Host and kernels include the headers of kernels/shared, so that their structs have
// one definition. Only 4-byte scalars and 16-byte vectors: float3 has other sizes on the two sides.
#pragma once

#ifndef __OPENCL_C_VERSION__
#include <cstdint>
#include <glm/vec4.hpp>

namespace pencil {
using float4 = glm::vec4;
using uint = std::uint32_t;
}  // namespace pencil

#define PENCIL_SHARED_BEGIN namespace pencil {
#define PENCIL_SHARED_END }
#else
#define PENCIL_SHARED_BEGIN
#define PENCIL_SHARED_END
#endif

#define WORD_BITS 32  // of a uint that holds a row of flags
