// kernels/lib/{paraboloid,cube,pyramid,superquadric}.cl against their double-precision references, through test-only kernels.
#include "cl/kernel_source.h"
#include "kernels/kernel_test.h"
#include "reference/all_maps.h"
#include "reference/tolerances.h"

namespace {

using namespace pencil;
using namespace pencil::test;

const char* const map_kernels = R"CL(
#define MAP_JOIN2(a, b) a##b
#define MAP_JOIN(a, b) MAP_JOIN2(a, b)
#define MAP(name) MAP_JOIN(PENCIL_MAP, name)
kernel void stored(int n, int count, global float4 *direction) {
    int i = get_global_id(0), stride = n + 2, in_tile = i % (stride * stride);
    if (i >= count) return;
    direction[i] = MAP(_stored_direction)((int2)(in_tile % stride - 1, in_tile / stride - 1), i / (stride * stride), n);
}
kernel void points(global const float4 *points, int count, global float4 *direction, global float *density) {
    int i = get_global_id(0);
    if (i >= count) return;
    direction[i] = MAP(_to_direction)(points[i].x, points[i].y, (int)points[i].z);
    density[i] = MAP(_solid_angle_density)(points[i].x, points[i].y, (int)points[i].z);
}
kernel void footprints(global const float *x, global const float *y, global const float *z, int packets, int n, global int *index,
                       global float *fx, global float *fy) {
    int i = get_global_id(0) * PENCIL_WIDTH;
    if (get_global_id(0) >= packets) return;
    Footprint f = MAP(_footprint)(PACKET_LOAD(x + i), PACKET_LOAD(y + i), PACKET_LOAD(z + i), n);
    PACKET_STORE(f.index, index + i);
    PACKET_STORE(f.fx, fx + i);
    PACKET_STORE(f.fy, fy + i);
}
)CL";

class Maps : public testing::TestWithParam<ref::NamedMap> {
protected:
    Launch kernel(const char* name) {
        const ref::NamedMap& named = GetParam();
        const std::string source = resolve_includes("#include \"lib/" + named.prefix + ".cl\"\n" + map_kernels, "test_maps");
        std::string options = "-cl-std=CL1.2 -DPENCIL_WIDTH=" + std::to_string(device()->packet_width()) + " -DPENCIL_MAP=" + named.prefix;
        if (!named.exponent.empty())
            options += " -DPENCIL_SUPERQUADRIC_EXPONENT=" + named.exponent + " -DPENCIL_SUPERQUADRIC_CONE=" + (named.cone ? "1" : "0");
        cl::Program program(device()->context(), source);
        program.build({device()->cl_device()}, options.c_str());
        return Launch(device(), cl::Kernel(program, name), name);
    }
    const ref::Map& map() const { return GetParam().map; }
};
INSTANTIATE_TEST_SUITE_P(Kinds, Maps, testing::ValuesIn(ref::comparison_maps()), [](const auto& test) {
    std::string name = test.param.map.name;
    for (char& c : name) c = c == ' ' || c == '.' ? '_' : c;
    return name;
});

TEST_P(Maps, StoredDirections) {
    for (const int n : {1, 5, 32}) {
        const int stride = n + 2, texels = stride * stride, count = texels * map().tiles;
        Buffer<float4> directions(device(), static_cast<std::size_t>(count), "directions");
        kernel("stored").args(n, count, directions).run(static_cast<std::size_t>(count), "stored");
        const std::vector<float4> direction = directions.read();
        for (int i = 0; i < count; ++i) {
            const int tile = i / texels, x = i % texels % stride - 1, y = i % texels / stride - 1;
            const dvec3 expected = glm::normalize(map().stored_direction(tile, x, y, n));
            const dvec3 got = glm::normalize(xyz(direction[static_cast<std::size_t>(i)]));
            ASSERT_LE(glm::distance(got, expected), tolerance::few_operations)
                << "n " << n << " tile " << tile << " texel " << x << " " << y;
        }
    }
}

TEST_P(Maps, DirectionsAndSolidAngleDensity) {
    Random random(5);
    std::vector<float4> points;
    for (int i = 0; i < 2000; ++i) points.push_back(to_float4({random.uniform(-1, 1), random.uniform(-1, 1), i % map().tiles}));
    const std::size_t count = points.size();
    Buffer<float4> given(device(), points, "points"), directions(device(), count, "directions");
    Buffer<float> densities(device(), count, "densities");
    kernel("points").args(given, static_cast<int>(count), directions, densities).run(count, "points");
    const std::vector<float4> direction = directions.read();
    const std::vector<float> density = densities.read();
    for (std::size_t i = 0; i < count; ++i) {
        const dvec2 uv(points[i].x, points[i].y);
        const int tile = static_cast<int>(points[i].z);
        const dvec3 expected = glm::normalize(map().to_direction(tile, uv)), got = glm::normalize(xyz(direction[i]));
        ASSERT_LE(glm::distance(got, expected), tolerance::few_operations) << "tile " << tile << " at " << uv.x << " " << uv.y;
        const double h = 1e-5;
        const double area = ref::solid_angle(map(), tile, uv - h, uv + h, 4) / (4.0 * h * h);
        const bool on_rim = map().covers(uv * (1.0 - 2.0 * h)) != map().covers(uv * (1.0 + 2.0 * h));
        if (on_rim) continue;
        ASSERT_NEAR(density[i], area, 1e-4 * area) << "tile " << tile << " at " << uv.x << " " << uv.y;
    }
}

/// Directions everywhere, along the axes and next to all seams.
std::vector<dvec3> directions_and_seams() {
    Random random(7);
    std::vector<dvec3> out;
    for (int code = 0; code < 27; ++code)
        if (code != 13) out.emplace_back(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
    for (const double zero : {0.0, -0.0, 1e-30, -1e-30, 1e-8, -1e-8})
        for (int i = 0; i < 20; ++i) {
            const double a = random.uniform(-1, 1), b = random.uniform(-1, 1);
            for (const dvec3& v : {dvec3(zero, a, b), dvec3(a, zero, b), dvec3(a, b, zero), dvec3(a, a + zero, b)}) out.push_back(v);
        }
    while (out.size() < 4096) out.push_back(random.direction() * std::pow(10.0, random.uniform(-6, 3)));
    for (dvec3& v : out) v = ref::as_float(v);
    return out;
}

/// The footprint's position in its tile, as a direction, is the direction that was asked for.
TEST_P(Maps, FootprintIsTheBilinearPosition) {
    const std::vector<dvec3> directions = directions_and_seams();
    std::vector<float> component[3];
    for (const dvec3& v : directions)
        for (int c = 0; c < 3; ++c) component[c].push_back(static_cast<float>(v[c]));
    Buffer<float> x(device(), component[0], "x"), y(device(), component[1], "y"), z(device(), component[2], "z");
    Buffer<int> index(device(), directions.size(), "index");
    Buffer<float> fx(device(), directions.size(), "fx"), fy(device(), directions.size(), "fy");
    const int packets = static_cast<int>(directions.size()) / device()->packet_width();
    for (const int n : {1, 26, 45}) {
        kernel("footprints").args(x, y, z, packets, n, index, fx, fy).run(static_cast<std::size_t>(packets), "footprints");
        const std::vector<int> first = index.read();
        const std::vector<float> weight_x = fx.read(), weight_y = fy.read();
        const int stride = n + 2, texels = stride * stride;
        for (std::size_t i = 0; i < directions.size(); ++i) {
            const int tile = first[i] / texels, column = first[i] % texels % stride, row = first[i] % texels / stride;
            ASSERT_TRUE(tile >= 0 && tile < map().tiles && column <= n && row <= n) << "direction " << i << " in tile " << tile;
            const dvec2 position(column + static_cast<double>(weight_x[i]), row + static_cast<double>(weight_y[i]));
            const dvec2 uv = (position - 0.5) * 2.0 / static_cast<double>(n) - 1.0;
            const dvec3 got = glm::normalize(map().to_direction(tile, uv)), expected = glm::normalize(directions[i]);
            ASSERT_LE(glm::distance(got, expected), 4.0 * tolerance::few_operations)
                << "n " << n << " direction " << expected.x << " " << expected.y << " " << expected.z << " in tile " << tile << " at "
                << uv.x << " " << uv.y;
        }
    }
}

/// Texels filled by their stored directions and read back bilinearly give a smooth function everywhere, seams included.
TEST_P(Maps, LookUpsPassTheSeams) {
    const auto smooth = [](const dvec3& d) {
        const dvec3 v = glm::normalize(d);
        return v.x + 2.0 * v.y * v.z - v.z;
    };
    double worst[2] = {0.0, 0.0};
    for (const int fine : {0, 1}) {
        const int n = fine ? 64 : 16, stride = n + 2, count = stride * stride * map().tiles;
        Buffer<float4> stored(device(), static_cast<std::size_t>(count), "directions");
        kernel("stored").args(n, count, stored).run(static_cast<std::size_t>(count), "stored");
        const std::vector<float4> held = stored.read();
        for (const dvec3& d : directions_and_seams()) {
            const ref::MapPoint p = map().to_point(d);
            const ref::Footprint f = ref::bilinear_footprint(p.uv, n);
            const auto at = [&](int dx, int dy) { return smooth(xyz(held[atlas_index(p.tile, f.x + dx, f.y + dy, n)])); };
            const double read = (at(0, 0) * (1 - f.fx) + at(1, 0) * f.fx) * (1 - f.fy) + (at(0, 1) * (1 - f.fx) + at(1, 1) * f.fx) * f.fy;
            worst[fine] = std::max(worst[fine], std::abs(read - smooth(d)));
        }
    }
    EXPECT_LT(worst[1], 0.1);
    EXPECT_LT(worst[1], worst[0] / 3.0) << "first order at creases and repeated texels, second order elsewhere";
}

}  // namespace
