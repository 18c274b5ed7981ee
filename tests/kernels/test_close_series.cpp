// The tail of the world's bounces is added to each pencil, rounded twice on every device.
#include "kernels/surface_test.h"
#include "surface/close_series.h"

namespace {

using namespace pencil;
using namespace pencil::test;

TEST(CloseSeries, AddsTheTailOfEveryPencil) {
    Kernels kernels = make_kernels();
    const glm::vec3 tail(0.3F, 7.7F, 0.0F);
    for (const int count : {1, 37, 1000}) {
        Random random(static_cast<std::uint32_t>(count));
        const std::vector<float4> last = random_irradiance(random, static_cast<std::size_t>(count) + 3),
                                  before = random_irradiance(random, last.size());
        Buffer<float4> total(device(), before, "total");
        close_series(kernels, Buffer<float4>(device(), last, "last"), tail, count, total);
        const std::vector<float4> after = total.read();
        for (std::size_t i = 0; i < after.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                const volatile float rest = tail[c] * last[i][c];
                const float expected = i < static_cast<std::size_t>(count) ? before[i][c] + rest : before[i][c];
                ASSERT_EQ(after[i][c], expected) << "pencil " << i << " of " << count << ", channel " << c;
            }
    }
}

/// E = source / (1 - r) for a source whose bounces shrink by r.
TEST(CloseSeries, IsTheWholeGeometricSeries) {
    Kernels kernels = make_kernels();
    const float r = 0.75F;
    float last = 1, sum = 1;
    for (int k = 0; k < 5; ++k) sum += last *= r;
    Buffer<float4> total(device(), {float4(sum, sum, sum, 0)}, "total");
    close_series(kernels, Buffer<float4>(device(), {float4(last, last, last, 0)}, "last"), glm::vec3(r / (1 - r)), 1, total);
    EXPECT_FLOAT_EQ(total.read().front().x, 1 / (1 - r));
}

}  // namespace
