// kernels/lib/map.cl for every kind of map, against the references of the maps, and what is made with it: geometry maps against a brute-force
// ray cast of every texel, gutters against what they fold to, visibility against segments.
#include "cl/kernel_source.h"
#include "kernels/map_comparison.h"
#include "line/test_visibility.h"
#include "reference/all_maps.h"
#include "reference/visibility_ref.h"
#include "visibility/geometry_maps.h"
#include "visibility/rasterize_clusters.h"
#include "visibility/trace_maps.h"

namespace pencil::test::map_kinds {
namespace {

const char* const map_kernels = R"CL(
#include "lib/map.cl"
/// Of every texel, row by row: itself, its direction (w: solid angle), its antipode, and its place in the orders of surfels and rays.
kernel void texels(int n, int count, global int2 *texel, global float4 *direction, global int2 *antipode, global int2 *surfel,
                   global int2 *ray) {
    int i = get_global_id(0);
    if (i >= count) return;
    texel[i] = map_texel_of_row(i % n, i / n, n);
    direction[i] = (float4)(map_texel_direction(texel[i], n).xyz, map_texel_solid_angle(texel[i], n));
    antipode[i] = map_antipode(texel[i], n);
    surfel[i] = map_surfel_texel(i, n);
    ray[i] = map_block_texel(i, n);
}
/// The texels up to two about each, 5 x 5 row by row.
kernel void beside(int n, int count, global int2 *found) {
    int i = get_global_id(0);
    if (i >= count) return;
    int2 texel = map_texel_of_row(i / 25 % n, i / 25 / n, n);
    found[i] = map_texel_beside(texel, (int2)(i % 5 - 2, i / 5 % 5 - 2), n);
}
kernel void folds(int n, int count, global int2 *found) {
    int i = get_global_id(0);
    if (i < count) found[i] = map_texel_beside((int2)(i % (n + 2) - 1, i / (n + 2) - 1), (int2)(0), n);
}
)CL";

struct Int2 {
    int x, y;
};
bool operator==(const Int2& a, const Int2& b) { return a.x == b.x && a.y == b.y; }

Kernels kernels_of(int kind) {
    Features features;
    features.map_kind = kind;
    features.film_samples = 4;
    return Kernels(device(), features);
}

class MapKinds : public testing::TestWithParam<int> {
protected:
    static Launch kernel(const char* name) {
        cl::Program program(device()->context(), resolve_includes(map_kernels, "test_map_kinds"));
        const std::string options =
            "-cl-std=CL1.2 -DPENCIL_WIDTH=" + std::to_string(device()->packet_width()) + " -DPENCIL_MAP_KIND=" + std::to_string(GetParam());
        program.build({device()->cl_device()}, options.c_str());
        return Launch(device(), cl::Kernel(program, name), name);
    }
    static ref::Map map() { return ref::render_maps()[static_cast<std::size_t>(GetParam())]; }
    static MapShape shape(int width) { return {GetParam(), width}; }
};
INSTANTIATE_TEST_SUITE_P(Kinds, MapKinds, testing::Range(0, 4), [](const auto& test) {
    std::string name = ref::render_maps()[static_cast<std::size_t>(test.param)].name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
});

/// Position of a texel of a tile in the atlas.
std::size_t stored_index(const MapShape& shape, int tile, const Int2& texel) {
    return static_cast<std::size_t>(tile * shape.stored() + (texel.y + 1) * (shape.n + 2) + texel.x + 1);
}

/// Panel and texel in it.
struct Place {
    int panel, x, y;
};
Place place_of(const MapShape& shape, const Int2& texel) {
    const int stride = shape.n + 2, panel = (texel.y + 1) / stride;
    return {panel, texel.x, texel.y - panel * stride};
}
bool is_interior(const MapShape& shape, const Int2& texel) {
    const Place p = place_of(shape, texel);
    return p.panel >= 0 && p.panel < shape.panels() && p.x >= 0 && p.x < shape.n && p.y >= 0 && p.y < shape.n;
}

/// As long as the kernels have it; the reference of the paraboloid gives unit vectors.
dvec3 direction_of(const ref::Map& map, const MapShape& shape, const Int2& texel) {
    const Place p = place_of(shape, texel);
    const dvec2 uv = ref::texel_centre(p.x, p.y, shape.n);
    const dvec3 direction = map.to_direction(p.panel, uv);
    return shape.kind == PENCIL_MAP_PARABOLOID ? 0.5 * (1.0 + glm::dot(uv, uv)) * glm::normalize(direction) : direction;
}

TEST_P(MapKinds, TexelsAndTheirAntipodes) {
    for (const int width : {8, 16, 64}) {
        const MapShape s = shape(width);
        const auto count = static_cast<std::size_t>(s.texels());
        Buffer<Int2> texels(device(), count, "texels"), antipodes(device(), count, "antipodes"), surfels(device(), count, "surfels"),
            rays(device(), count, "rays");
        Buffer<float4> directions(device(), count, "directions");
        kernel("texels").args(s.n, s.texels(), texels, directions, antipodes, surfels, rays).run(count, "texels");
        const std::vector<Int2> texel = texels.read(), antipode = antipodes.read();
        const std::vector<float4> direction = directions.read();
        double sphere = 0;
        for (std::size_t i = 0; i < count; ++i) {
            SCOPED_TRACE("n " + std::to_string(s.n) + " texel " + std::to_string(texel[i].x) + " " + std::to_string(texel[i].y));
            ASSERT_TRUE(is_interior(s, texel[i]) && is_interior(s, antipode[i]));
            const dvec3 seen = xyz(direction[i]), expected = direction_of(map(), s, texel[i]);
            ASSERT_LE(glm::distance(seen, expected), tolerance::few_operations);
            ASSERT_LE(glm::distance(direction_of(map(), s, antipode[i]), -expected), tolerance::few_operations);
            const TexelView view = texel_view(s, static_cast<int>(i) % s.n, static_cast<int>(i) / s.n);
            ASSERT_LE(glm::distance(view.direction, expected), tolerance::few_operations);
            ASSERT_NEAR(view.solid_angle * 4.0 / (s.n * s.n), direction[i].w, tolerance::few_operations);
            sphere += static_cast<double>(direction[i].w);
        }
        EXPECT_NEAR(sphere / (4.0 * ref::pi), 1.0, width == 64 ? 5e-3 : 0.1) << "solid angles are those of texel centres";
        for (const std::vector<Int2>& order : {surfels.read(), rays.read(), antipode}) {
            std::vector<int> times(static_cast<std::size_t>(s.stored()), 0);
            for (const Int2& t : order) ++times[stored_index(s, 0, t)];
            for (const Int2& t : texel) ASSERT_EQ(times[stored_index(s, 0, t)], 1) << "texel " << t.x << " " << t.y;
        }
    }
}

TEST_P(MapKinds, WhatLiesAcrossSeams) {
    const ref::Map m = map();
    for (const int width : {8, 16, 64}) {
        const MapShape s = shape(width);
        const int count = 25 * s.texels();
        Buffer<Int2> neighbours(device(), static_cast<std::size_t>(count), "neighbours");
        kernel("beside").args(s.n, count, neighbours).run(static_cast<std::size_t>(count), "beside");
        const std::vector<Int2> found = neighbours.read();
        const double texel = 2.0 / s.n;
        for (int i = 0; i < count; ++i) {
            const int row = i / 25 / s.n, panel = row / s.n, x = i / 25 % s.n + i % 5 - 2, y = row % s.n + i / 5 % 5 - 2;
            SCOPED_TRACE("n " + std::to_string(s.n) + " panel " + std::to_string(panel) + " texel " + std::to_string(x) + " " +
                         std::to_string(y));
            const Int2& t = found[static_cast<std::size_t>(i)];
            ASSERT_TRUE(is_interior(s, t)) << t.x << " " << t.y;
            const bool out_x = x < 0 || x >= s.n, out_y = y < 0 || y >= s.n;
            if (!out_x && !out_y) {
                ASSERT_TRUE((t == Int2{x, y + panel * (s.n + 2)}));
                continue;
            }
            // The reference knows one texel beyond the edge. The corner of a cube is no texel's; a paraboloid's texels do not meet at the rim.
            const int near_x = std::clamp(x, -1, s.n), near_y = std::clamp(y, -1, s.n);
            const bool between = m.name == "paraboloid" || (m.name == "cube" && out_x && out_y), far = near_x != x || near_y != y;
            const dvec3 expected = glm::normalize(m.stored_direction(panel, near_x, near_y, s.n));
            const dvec3 got = glm::normalize(direction_of(m, s, t));
            ASSERT_LE(glm::distance(got, expected), far ? 4.0 * texel : between ? 1.5 * texel : tolerance::few_operations);
        }
    }
}

DeviceScene prepared_scene(const TestScene& scene) {
    return DeviceScene(device(), scene.flat, build_bvh(scene.flat.triangles), cluster_triangles(scene.flat.triangles));
}

using MakeMaps = void (*)(Kernels&, const DeviceScene&, GeometryMaps&, int, int);

/// Ways to make maps of a kind.
std::vector<std::pair<const char*, MakeMaps>> ways(int kind) {
    std::vector<std::pair<const char*, MakeMaps>> out{{"traced", trace_maps}};
    if (PENCIL_MAP_FACETS(kind) > 0) out.emplace_back("drawn", rasterize_clusters);
    return out;
}

std::vector<Hit> made(MakeMaps make, int kind, const TestScene& scene, const std::vector<float4>& centres, const MapShape& shape) {
    Kernels kernels = kernels_of(kind);
    GeometryMaps maps(device(), centres, shape, "test");
    make(kernels, prepared_scene(scene), maps, 0, maps.count);
    return maps.hits.read();
}

Comparison compare(const ref::Map& map, const MapShape& shape, const TestScene& scene, const std::vector<float4>& centres,
                   const std::vector<Hit>& hits) {
    Comparison out;
    for (int tile = 0; tile < static_cast<int>(centres.size()); ++tile)
        for (int i = 0; i < shape.texels(); ++i) {
            const int row = i / shape.n, panel = row / shape.n;
            const Int2 texel{i % shape.n, row + 2 * panel};
            compare_texel(scene, xyz(centres[static_cast<std::size_t>(tile)]), direction_of(map, shape, texel),
                          hits[stored_index(shape, tile, texel)],
                          "tile " + std::to_string(tile) + " texel " + std::to_string(texel.x) + " " + std::to_string(texel.y), out);
        }
    EXPECT_EQ(out.wrong, 0) << "of " << out.texels << " texels; first: " << out.first_wrong;
    return out;
}

TEST_P(MapKinds, GeometryIsThatOfBruteForce) {
    for (const auto& [name, make] : ways(GetParam()))
        for (const int triangles : {1, 40, 300}) {
            const int width = triangles == 300 ? 32 : 16;
            SCOPED_TRACE(std::string(name) + ", " + std::to_string(triangles) + " triangles");
            Random random(static_cast<std::uint32_t>(triangles));
            const TestScene scene = soup_scene(static_cast<std::uint32_t>(triangles + 7), triangles);
            const std::vector<float4> centres = random_centres(random, 3, 0.95);
            const Comparison c = compare(map(), shape(width), scene, centres, made(make, GetParam(), scene, centres, shape(width)));
            EXPECT_LE(c.ties, 2 + 2e-4 * c.texels) << "of " << c.texels;
        }
}

TEST_P(MapKinds, GeometryFromCentresOnAndNearTriangles) {
    const TestScene scene = soup_scene(12, 60);
    std::vector<float4> centres;
    for (std::size_t i = 0; i < 8; ++i) {
        const ref::Triangle& t = scene.triangles[i];
        const dvec3 normal = glm::normalize(glm::cross(t.v1 - t.v0, t.v2 - t.v0)), middle = (t.v0 + t.v1 + t.v2) / 3.0;
        for (const dvec3& p : {t.v0, 0.5 * (t.v1 + t.v2), middle, middle + 1e-3 * normal, middle + 1e-6 * normal})
            centres.push_back(to_float4(p));
    }
    for (const auto& [name, make] : ways(GetParam())) {
        SCOPED_TRACE(name);
        compare(map(), shape(16), scene, centres, made(make, GetParam(), scene, centres, shape(16)));
    }
}

TEST_P(MapKinds, ClosedBoxHasNoHoles) {
    // From these centres diagonals and box edges pass through texel centres.
    const TestScene scene = box_scene(13);
    const std::vector<float4> centres{to_float4(dvec3(0.0)), to_float4({0.25, 0.25, 0.25}), to_float4({0.5, 0, 0}),
                                      to_float4({0, -0.5, 0.5})};
    for (const auto& [name, make] : ways(GetParam()))
        for (const int width : {8, 16, 64}) {
            const std::vector<Hit> hits = made(make, GetParam(), scene, centres, shape(width));
            ASSERT_EQ(std::count_if(hits.begin(), hits.end(), [](const Hit& hit) { return hit.triangle < 0; }), 0)
                << name << ", gutters included";
        }
}

TEST_P(MapKinds, GuttersShowWhatLiesAcross) {
    const TestScene scene = room_scene(31, 40);
    Random random(32);
    const std::vector<float4> centres = random_centres(random, 2);
    const MapShape s = shape(32);
    const std::vector<Hit> hits = made(make_geometry_maps, GetParam(), scene, centres, s);
    Buffer<Int2> folds(device(), static_cast<std::size_t>(s.stored()), "folds");
    kernel("folds").args(s.n, s.stored(), folds).run(static_cast<std::size_t>(s.stored()), "folds");
    const std::vector<Int2> fold = folds.read();
    for (int tile = 0; tile < 2; ++tile)
        for (int i = 0; i < s.stored(); ++i) {
            const Hit &shown = hits[static_cast<std::size_t>(tile * s.stored() + i)],
                      &source = hits[stored_index(s, tile, fold[static_cast<std::size_t>(i)])];
            ASSERT_TRUE(shown.triangle == source.triangle && shown.disparity == source.disparity) << "tile " << tile << " texel " << i;
        }
}

/// Visibility of the surfels that pencils see by their maps, in a room with things in it, against segments.
TEST_P(MapKinds, VisibilityIsThatOfSegments) {
    const TestScene scene = room_scene(67, 25);
    Kernels kernels = kernels_of(GetParam());
    const DeviceScene on_device = prepared_scene(scene);
    Random random(68);
    const std::vector<float4> centres = random_centres(random, 20), viewers = random_centres(random, 3);
    const MapShape s = shape(64);
    GeometryMaps maps(device(), centres, s, "test"), seen(device(), viewers, shape(24), "test");
    make_geometry_maps(kernels, on_device, maps, 0, maps.count);
    make_geometry_maps(kernels, on_device, seen, 0, seen.count);
    Surfels surfels(device(), seen.count * seen.texels(), "test surfels");
    gather_surfels(kernels, on_device, seen, 0, seen.count, surfels);
    Buffer<uint> mask(device(), static_cast<std::size_t>(surfels.capacity), "mask");
    test_visibility(kernels, on_device, surfels, maps, mask);
    const HostSurfels host(surfels);
    const std::vector<uint> bits = mask.read();
    int pairs = 0, leaks = 0, acne = 0;
    for (int i = 0; i < host.count; ++i)
        for (int p = 0; p < maps.count; ++p) {
            const dvec3 x = host.position(i), c = xyz(centres[static_cast<std::size_t>(p)]);
            if (host.plane(i) < 0 || glm::dot(host.face_normal(i), c - x) < 1e-6) continue;
            const ref::Visibility truth = ref::segment_visibility(scene.triangles, x, c, {host.plane(i)});
            if (truth.margin < 1e-6) continue;
            const bool visible = (bits[static_cast<std::size_t>(i)] >> p & 1U) != 0U;
            ++pairs;
            leaks += visible && !truth.visible ? 1 : 0;
            acne += !visible && truth.visible ? 1 : 0;
        }
    std::printf("%s: %d pairs, leaks %.3f %%, acne %.3f %%\n", map().name.c_str(), pairs, 100.0 * leaks / pairs, 100.0 * acne / pairs);
    EXPECT_GT(pairs, 10000);
    EXPECT_LE(leaks + acne, 0.015 * pairs);
}

/// A room cut by a two-sided sheet that stands on its floor: the floor's plane goes on behind the sheet.
TEST_P(MapKinds, NothingIsSeenThroughAStandingSheet) {
    std::vector<ref::Triangle> triangles = box_triangles();
    const double h = 0.75;
    triangles.push_back({{0, -h, -h}, {0, h, -h}, {0, h, h}, 6});
    triangles.push_back({{0, -h, -h}, {0, h, h}, {0, -h, h}, 6});
    const TestScene scene = make_scene(triangles, 14, 69);
    Kernels kernels = kernels_of(GetParam());
    const DeviceScene on_device = prepared_scene(scene);
    Random random(70);
    std::vector<float4> centres, viewers;
    for (int i = 0; i < 32; ++i)
        centres.push_back(to_float4({-random.uniform(0.02, 0.7), random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7)}));
    for (int i = 0; i < 16; ++i)
        viewers.push_back(to_float4({random.uniform(0.02, 0.7), random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7)}));
    GeometryMaps seen(device(), viewers, shape(64), "test");
    make_geometry_maps(kernels, on_device, seen, 0, seen.count);
    Surfels surfels(device(), seen.count * seen.texels(), "test surfels");
    gather_surfels(kernels, on_device, seen, 0, seen.count, surfels);
    const HostSurfels host(surfels);
    for (const int width : {32, 64}) {
        GeometryMaps maps(device(), centres, shape(width), "test");
        make_geometry_maps(kernels, on_device, maps, 0, maps.count);
        Buffer<uint> mask(device(), static_cast<std::size_t>(surfels.capacity), "mask");
        test_visibility(kernels, on_device, surfels, maps, mask);
        const std::vector<uint> bits = mask.read();
        int leaks = 0, pairs = 0;
        for (int i = 0; i < host.count; ++i) {
            if (host.plane(i) < 0 || host.position(i).x < 1e-5) continue;
            pairs += maps.count;
            for (uint rest = bits[static_cast<std::size_t>(i)]; rest != 0; rest &= rest - 1) ++leaks;
        }
        std::printf("%s, %d: %d leaks of %d pairs\n", map().name.c_str(), shape(width).n, leaks, pairs);
        // Where sheet, floor and wall meet the sheet may fall between four texels.
        EXPECT_LE(leaks, (width == 32 ? 5e-4 : 1e-4) * pairs);
    }
}

}  // namespace
}  // namespace pencil::test::map_kinds
