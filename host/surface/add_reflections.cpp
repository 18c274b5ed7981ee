#include "surface/add_reflections.h"

namespace pencil {

void add_reflections(Kernels& kernels, const Buffer<float>& radiance, const Surfels& chains, const Buffer<int>& starts, int shared,
                     int capacity, Buffer<float>& outgoing) {
    const int count = static_cast<int>(starts.size());
    kernels.get("add_reflections")
        .args(radiance, chains.capacity, starts, count, shared, capacity, outgoing)
        .run(starts.size() / static_cast<std::size_t>(shared), "reflections");
}

}  // namespace pencil
