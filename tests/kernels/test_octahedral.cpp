// kernels/lib/octahedral.cl and footprint.cl against the double-precision map, through test-only kernels.
#include "cl/kernel_source.h"
#include "kernels/kernel_test.h"
#include "reference/tolerances.h"

namespace {

using namespace pencil;
using namespace pencil::test;

const char* const octahedral_kernels = R"CL(
#include "lib/footprint.cl"
#include "lib/octahedral.cl"
#include "lib/packet.cl"
kernel void texels(int n, int count, global float4 *direction, global int2 *antipode, global int2 *folded) {
    int i = get_global_id(0), stride = n + 2;
    if (i >= count) return;
    folded[i] = oct_fold_texel((int2)(i % stride - 1, i / stride - 1), n);
    direction[i] = oct_texel_direction(folded[i], n);
    antipode[i] = oct_antipode(folded[i], n);
}
kernel void footprints(global const float *x, global const float *y, global const float *z, int packets, int n, global int *index,
                       global float *fx, global float *fy) {
    int i = get_global_id(0) * PENCIL_WIDTH;
    if (get_global_id(0) >= packets) return;
    Footprint f = packet_footprint(PACKET_LOAD(x + i), PACKET_LOAD(y + i), PACKET_LOAD(z + i), n);
    PACKET_STORE(f.index, index + i);
    PACKET_STORE(f.fx, fx + i);
    PACKET_STORE(f.fy, fy + i);
}
)CL";

struct Int2 {
    int x, y;
};

Launch test_kernel(const char* name) {
    cl::Program program(device()->context(), resolve_includes(octahedral_kernels, "test_octahedral"));
    const std::string options = "-cl-std=CL1.2 -DPENCIL_WIDTH=" + std::to_string(device()->packet_width());
    program.build({device()->cl_device()}, options.c_str());
    return Launch(device(), cl::Kernel(program, name), name);
}

class Octahedral : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sizes, Octahedral, testing::Values(2, 4, 6, 10, 64, 256));

TEST_P(Octahedral, TexelDirectionFoldAndAntipode) {
    const int n = GetParam(), stride = n + 2, count = stride * stride;
    Buffer<float4> directions(device(), static_cast<std::size_t>(count), "directions");
    Buffer<Int2> antipodes(device(), static_cast<std::size_t>(count), "antipodes"),
        folds(device(), static_cast<std::size_t>(count), "folds");
    test_kernel("texels").args(n, count, directions, antipodes, folds).run(static_cast<std::size_t>(count), "texels");
    const std::vector<float4> direction = directions.read();
    const std::vector<Int2> antipode = antipodes.read(), fold = folds.read();
    for (int i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const int x = i % stride - 1, y = i / stride - 1;
        const ref::Texel f = ref::fold(x, y, n), a = ref::antipodal_texel(f.x, f.y, n);
        ASSERT_TRUE(fold[k].x == f.x && fold[k].y == f.y)
            << "texel " << x << " " << y << " folds to " << fold[k].x << " " << fold[k].y << ", not " << f.x << " " << f.y;
        ASSERT_TRUE(antipode[k].x == a.x && antipode[k].y == a.y) << "texel " << f.x << " " << f.y << " is opposite to " << antipode[k].x
                                                                  << " " << antipode[k].y << ", not " << a.x << " " << a.y;
        const dvec3 expected = ref::texel_direction(f.x, f.y, n), got = xyz(direction[k]);
        ASSERT_LE(glm::distance(got, expected), tolerance::few_operations) << "texel " << f.x << " " << f.y;
    }
}

/// Random directions of all lengths, axes, and the neighbourhood of the seam v_z < 0, v_x or v_y = +-0.
std::vector<dvec3> awkward_directions() {
    Random random(7);
    std::vector<dvec3> out;
    for (int code = 0; code < 27; ++code)
        if (code != 13) out.emplace_back(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
    for (const double zero : {0.0, -0.0, 1e-30, -1e-30, 1e-8, -1e-8}) {
        for (int i = 0; i < 20; ++i) {
            out.emplace_back(zero, random.uniform(-1, 1), -random.uniform());
            out.emplace_back(random.uniform(-1, 1), zero, -random.uniform());
        }
        out.emplace_back(zero, zero, -1);
    }
    while (out.size() < 4096) out.push_back(random.direction() * std::pow(10.0, random.uniform(-6, 3)));
    for (dvec3& v : out) v = ref::as_float(v);
    return out;
}

TEST_P(Octahedral, FootprintIsTheBilinearPosition) {
    const int n = GetParam(), stride = n + 2;
    const std::vector<dvec3> directions = awkward_directions();
    std::vector<float> component[3];
    for (const dvec3& v : directions)
        for (int c = 0; c < 3; ++c) component[c].push_back(static_cast<float>(v[c]));
    Buffer<float> x(device(), component[0], "x"), y(device(), component[1], "y"), z(device(), component[2], "z");
    Buffer<int> index(device(), directions.size(), "index");
    Buffer<float> fx(device(), directions.size(), "fx"), fy(device(), directions.size(), "fy");
    const int packets = static_cast<int>(directions.size()) / device()->packet_width();
    test_kernel("footprints").args(x, y, z, packets, n, index, fx, fy).run(static_cast<std::size_t>(packets), "footprints");
    const std::vector<int> first = index.read();
    const std::vector<float> weight_x = fx.read(), weight_y = fy.read();
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const int column = first[i] % stride, row = first[i] / stride;
        ASSERT_TRUE(column >= 0 && column <= n && row >= 0 && row <= n) << "direction " << i << " footprint at " << column << " " << row;
        ASSERT_TRUE(weight_x[i] >= 0.0F && weight_x[i] <= 1.0F && weight_y[i] >= 0.0F && weight_y[i] <= 1.0F) << "direction " << i;
        // Gutter texel -1 is column 0. Compared as directions: both copies of a point on the seam are right.
        const dvec2 uv((column + static_cast<double>(weight_x[i]) - 0.5) * 2.0 / n - 1.0,
                       (row + static_cast<double>(weight_y[i]) - 0.5) * 2.0 / n - 1.0);
        const dvec3 got = ref::oct_to_direction(uv), expected = directions[i] / ref::l1_norm(directions[i]);
        ASSERT_LE(glm::distance(got, expected), 2.0 * tolerance::few_operations)
            << "direction " << i << ": " << expected.x << " " << expected.y << " " << expected.z << " -> " << uv.x << " " << uv.y;
    }
}

}  // namespace
