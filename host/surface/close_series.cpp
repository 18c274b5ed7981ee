#include "surface/close_series.h"

namespace pencil {

void close_series(Kernels& kernels, const Buffer<float4>& last, const glm::vec3& tail, int count, Buffer<float4>& total) {
    kernels.get("close_series").args(last, float4(tail, 0), count, total).run(static_cast<std::size_t>(count), "close series");
}

}  // namespace pencil
