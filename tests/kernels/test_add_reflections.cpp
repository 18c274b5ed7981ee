// Chains join the surfels that they start on.
#include "kernels/kernel_test.h"
#include "reference/tolerances.h"
#include "surface/add_reflections.h"

namespace {

using namespace pencil;
using namespace pencil::test;

TEST(AddReflections, AreTheMeanOfEachSurfelsChains) {
    Random random(41);
    const int surfels = 300, shared = 4, capacity = surfel_capacity(surfels);
    std::vector<int> chosen, starts;
    for (int i = 0; i < surfels; i += 1 + random.index(3)) chosen.push_back(i);
    for (const int i : chosen) starts.insert(starts.end(), shared, i);
    const Surfels chains(device(), static_cast<int>(starts.size()), "chains");
    std::vector<float> radiance(static_cast<std::size_t>(chains.capacity) * 3), before(static_cast<std::size_t>(capacity) * 3);
    for (float& v : radiance) v = static_cast<float>(random.uniform());
    for (float& v : before) v = static_cast<float>(random.uniform());
    Buffer<float> outgoing(device(), before, "outgoing");
    Kernels kernels = make_kernels();
    add_reflections(kernels, Buffer<float>(device(), radiance, "radiance"), chains, Buffer<int>(device(), starts, "starts"), shared,
                    capacity, outgoing);
    const std::vector<float> got = outgoing.read();
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        dvec3 expected = rgb_at(before, static_cast<std::size_t>(capacity), chosen[k]);
        for (int s = 0; s < shared; ++s)
            expected += rgb_at(radiance, static_cast<std::size_t>(chains.capacity), static_cast<int>(k) * shared + s) / 4.0;
        expect_close(rgb_at(got, static_cast<std::size_t>(capacity), chosen[k]), expected, tolerance::few_operations, "surfel");
    }
    for (int i = 0; i < surfels; ++i) {
        if (std::find(chosen.begin(), chosen.end(), i) != chosen.end()) continue;
        EXPECT_EQ(rgb_at(got, static_cast<std::size_t>(capacity), i), rgb_at(before, static_cast<std::size_t>(capacity), i));
    }
}

}  // namespace
