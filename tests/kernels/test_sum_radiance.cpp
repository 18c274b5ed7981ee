// Mean radiance of a pencil set: every interior texel counts once, gutters do not.
#include <fstream>
#include <sstream>

#include "kernels/kernel_test.h"
#include "line/sum_radiance.h"
#include "reference/tolerances.h"

namespace {

using namespace pencil;
using namespace pencil::test;

TEST(SumRadiance, MeanOfInteriorTexels) {
    Random random(141);
    for (const int n : {8, 24, 64}) {
        for (const int tiles : {1, 3, 37}) {
            Kernels kernels = make_kernels();
            PencilSet set(device(), std::make_shared<GeometryMaps>(device(), random_centres(random, tiles), n, "test"));
            std::vector<float4> texels(set.radiance.size(), float4(1e6F));  // the gutters keep this
            dvec3 sum(0.0);
            for (int tile = 0; tile < tiles; ++tile) {
                for (int i = 0; i < n * n; ++i) {
                    float4& texel = texels[atlas_index(tile, i % n, i / n, n)];
                    texel = to_float4(random.in_box(0.0, 2.0), 7.0);
                    sum += xyz(texel) / static_cast<double>(tiles * n * n);
                }
            }
            set.radiance.write(texels);
            expect_close(sum_radiance(kernels, set), sum, tolerance::accumulation,
                         "n " + std::to_string(n) + " tiles " + std::to_string(tiles));
        }
    }
}

std::string text_of(const std::string& file) {
    std::ifstream in(PENCIL_SOURCE_DIR + ("/" + file));
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

TEST(AddingAKernelPage, ShowsTheKernelAndItsLauncher) {
    const std::string page = text_of("docs/adding_a_kernel.md");
    for (const char* file : {"kernels/sum_radiance.cl", "host/line/sum_radiance.cpp"})
        EXPECT_NE(page.find(text_of(file)), std::string::npos) << "docs/adding_a_kernel.md and " << file << " differ";
}

}  // namespace
