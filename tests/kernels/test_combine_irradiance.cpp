// Sums of multiples of rows of irradiance, against double precision.
#include "kernels/surface_test.h"
#include "reference/tolerances.h"
#include "surface/combine_irradiance.h"

namespace {

using namespace pencil;
using namespace pencil::test;

TEST(CombineIrradiance, AddsMultiplesOfRows) {
    Kernels kernels = make_kernels();
    for (const int count : {1, 37, 1000}) {
        Random random(static_cast<std::uint32_t>(count));
        const auto size = static_cast<std::size_t>(count);
        const std::vector<float4> rows = random_irradiance(random, 4 * size), before = random_irradiance(random, size + 3);
        const std::vector<dvec3> factors{{1, 0.5, 0}, {-1, 2, 3}, {0.25, -0.125, 7}};
        Buffer<float4> target(device(), before, "target");
        combine_irradiance(kernels, Buffer<float4>(device(), rows, "rows"), factors, count, target);
        const std::vector<float4> after = target.read();
        for (std::size_t i = 0; i < size; ++i) {
            dvec3 expected = xyz(before[i]), size_of_terms = expected;
            for (std::size_t k = 0; k < factors.size(); ++k) {
                expected += factors[k] * xyz(rows[k * size + i]);
                size_of_terms += glm::abs(factors[k]) * xyz(rows[k * size + i]);
            }
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(after[i][c], expected[c], tolerance::accumulation * size_of_terms[c]) << "pencil " << i << " of " << count;
        }
        for (std::size_t i = size; i < before.size(); ++i) EXPECT_EQ(after[i], before[i]) << "beyond the set";
    }
}

}  // namespace
