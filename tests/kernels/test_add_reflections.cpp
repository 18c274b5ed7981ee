// Chains join the surfels that they start on.
#include "kernels/kernel_test.h"
#include "reference/tolerances.h"
#include "surface/add_reflections.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// Beside even light: what film pencils have added since `before`.
TEST(AddReflections, AreTheMeanOfEachSurfelsChains) {
    Random random(41);
    const int surfels = 300, shared = 4, capacity = surfel_capacity(surfels);
    std::vector<int> chosen, starts;
    for (int i = 0; i < surfels; i += 1 + random.index(3)) chosen.push_back(i);
    for (const int i : chosen) starts.insert(starts.end(), shared, i);
    Chains chains{Surfels(device(), static_cast<int>(starts.size()), "chains"), {}};
    const auto chain_capacity = static_cast<std::size_t>(chains.ends.capacity);
    const auto drawn = [&](std::size_t count, double low) {
        std::vector<float> values(count);
        for (float& v : values) v = static_cast<float>(random.uniform(low, 1.0));
        return values;
    };
    const std::vector<float> radiance = drawn(3 * chain_capacity, 0.0), uneven = drawn(starts.size(), -1.0),
                             pencils = drawn(static_cast<std::size_t>(capacity) * 3, 0.0);
    std::vector<float> before = pencils;
    for (float& v : before) v *= static_cast<float>(random.uniform());
    chains.uneven = Buffer<float>(device(), uneven, "uneven");
    Buffer<float> outgoing(device(), pencils, "outgoing");
    Kernels kernels = make_kernels();
    add_reflections(kernels, chains, Buffer<float>(device(), radiance, "radiance"), Buffer<int>(device(), starts, "starts"), shared,
                    Buffer<float>(device(), before, "before"), capacity, outgoing);
    const std::vector<float> got = outgoing.read();
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        const dvec3 lit = rgb_at(pencils, static_cast<std::size_t>(capacity), chosen[k]),
                    even = lit - rgb_at(before, static_cast<std::size_t>(capacity), chosen[k]);
        dvec3 expected = lit;
        for (int s = 0; s < shared; ++s) {
            const int chain = static_cast<int>(k) * shared + s;
            expected +=
                (rgb_at(radiance, chain_capacity, chain) - static_cast<double>(uneven[static_cast<std::size_t>(chain)]) * even) / 4.0;
        }
        expect_close(rgb_at(got, static_cast<std::size_t>(capacity), chosen[k]), expected, tolerance::few_operations, "surfel");
    }
    for (int i = 0; i < surfels; ++i) {
        if (std::find(chosen.begin(), chosen.end(), i) != chosen.end()) continue;
        EXPECT_EQ(rgb_at(got, static_cast<std::size_t>(capacity), i), rgb_at(pencils, static_cast<std::size_t>(capacity), i));
    }
}

}  // namespace
