// Inner products of rows of irradiance, against double precision, and the same bits each time.
#include "kernels/surface_test.h"
#include "reference/tolerances.h"
#include "surface/dot_irradiance.h"

namespace {

using namespace pencil;
using namespace pencil::test;

TEST(DotIrradiance, IsTheSumOfProducts) {
    Kernels kernels = make_kernels();
    for (const int count : {1, 37, 64, 1000})
        for (const int vectors : {1, 5}) {
            Random random(static_cast<std::uint32_t>(count));
            const auto size = static_cast<std::size_t>(count);
            const std::vector<float4> rows = random_irradiance(random, 7 * size), other = random_irradiance(random, size);
            const Buffer<float4> basis(device(), rows, "basis"), x(device(), other, "other");
            const std::vector<dvec3> got = dot_irradiance(kernels, basis, vectors, x, count);
            ASSERT_EQ(got.size(), static_cast<std::size_t>(vectors));
            for (std::size_t k = 0; k < got.size(); ++k) {
                dvec3 expected(0);
                for (std::size_t i = 0; i < size; ++i) expected += xyz(rows[k * size + i]) * xyz(other[i]);
                expect_close(got[k], expected, tolerance::accumulation, "row " + std::to_string(k) + " of " + std::to_string(count));
            }
            EXPECT_EQ(got, dot_irradiance(kernels, basis, vectors, x, count));
        }
}

}  // namespace
