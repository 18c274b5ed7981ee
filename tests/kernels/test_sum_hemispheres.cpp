// Irradiance of surface pencils: pi / n^2 times the radiance of their texels.
#include "kernels/surface_test.h"
#include "reference/tolerances.h"
#include "surface/sum_hemispheres.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr float never_summed = -7;

struct Summed {
    std::vector<float> radiance;  // [3][capacity]
    int capacity;
    std::vector<float4> irradiance;
};

/// Pencils first .. first + count of texels from first_surfel on; `value` < 0: random radiance.
Summed sum(int first_surfel, int first, int count, int n, double value = -1) {
    Random random(static_cast<std::uint32_t>(count * n));
    Summed s;
    s.capacity = surfel_capacity(first_surfel + count * n * n);
    for (int i = 0; i < 3 * s.capacity; ++i) s.radiance.push_back(static_cast<float>(value < 0 ? random.uniform(0, 5) : value));
    Buffer<float4> irradiance(device(), std::vector<float4>(static_cast<std::size_t>(first + count + 3), float4(never_summed)),
                              "irradiance");
    Kernels kernels = make_kernels();
    sum_hemispheres(kernels, Buffer<float>(device(), s.radiance, "radiance"), s.capacity, first_surfel, first, count, n, irradiance);
    s.irradiance = irradiance.read();
    return s;
}

TEST(SumHemispheres, IsTheSumOverTexels) {
    for (const int n : {4, 8, 12})
        for (const int count : {1, 37, 130}) {
            const int first_surfel = 16 * (count % 3), first = count % 5;
            const Summed s = sum(first_surfel, first, count, n);
            for (int p = 0; p < count; ++p) {
                dvec3 expected(0);
                for (int i = 0; i < n * n; ++i)
                    expected += rgb_at(s.radiance, static_cast<std::size_t>(s.capacity), first_surfel + p * n * n + i);
                expected *= ref::pi / (n * n);
                const float4& got = s.irradiance[static_cast<std::size_t>(first + p)];
                expect_close(xyz(got), expected, tolerance::accumulation, "pencil " + std::to_string(p) + ", n " + std::to_string(n));
                EXPECT_EQ(got.w, 0.0F);
            }
            for (int p = 0; p < first; ++p)
                EXPECT_EQ(s.irradiance[static_cast<std::size_t>(p)], float4(never_summed)) << "before the first";
            for (std::size_t p = static_cast<std::size_t>(first + count); p < s.irradiance.size(); ++p)
                EXPECT_EQ(s.irradiance[p], float4(never_summed)) << "behind the last";
        }
}

TEST(SumHemispheres, UniformRadianceIsPi) {
    for (const float4& e : sum(0, 0, 5, 8, 2.0).irradiance) {
        if (e == float4(never_summed)) continue;
        expect_close(xyz(e), dvec3(2.0 * ref::pi), tolerance::accumulation, "radiance 2");
    }
}

}  // namespace
