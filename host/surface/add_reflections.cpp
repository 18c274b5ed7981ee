#include "surface/add_reflections.h"

namespace pencil {

void add_reflections(Kernels& kernels, const Chains& chains, const Buffer<float>& radiance, const Buffer<int>& starts, int shared,
                     const Buffer<float>& before, int capacity, Buffer<float>& outgoing) {
    const int count = static_cast<int>(starts.size());
    kernels.get("add_reflections")
        .args(radiance, chains.ends.capacity, chains.uneven, starts, count, shared, before, capacity, outgoing)
        .run(starts.size() / static_cast<std::size_t>(shared), "reflections");
}

}  // namespace pencil
