// What the kernel tests share: a device, scenes of triangle soup or of a box in device memory, atlas and surfel access by index.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"
#include "device/surfels.h"
#include "line/gather_surfels.h"
#include "line/weights.h"
#include "reference/octahedral_ref.h"
#include "reference/random.h"
#include "reference/raycast_ref.h"
#include "visibility/rasterize_octahedral.h"

namespace pencil::test {

using ref::dvec2;
using ref::dvec3;
using ref::Random;

/// $PENCIL_DEVICE selects the device of all device tests.
inline const std::shared_ptr<Device>& device() {
    static const std::shared_ptr<Device> opened = Device::open("");
    return opened;
}

inline float4 to_float4(const dvec3& v, double w = 0.0) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}
inline dvec3 xyz(const float4& v) { return {v.x, v.y, v.z}; }

/// Scene of the reference and the same in device form.
struct TestScene {
    std::vector<ref::Triangle> triangles;
    FlatScene flat;
};

inline Material random_material(Random& random) {
    Material m{};
    m.albedo = to_float4(random.in_box(0.05, 0.95), random.uniform() < 0.5 ? 1.0 : 0.0);
    m.emission = to_float4(random.in_box(0.0, 5.0), random.uniform() < 0.5 ? 1.0 : 0.0);
    return m;
}

/// One plane per value of ref::Triangle::plane (values 0, 1, ... in order of first use); `materials` shapes, and materials,
/// dealt out in turn: shapes to triangles, materials to pairs of them.
inline TestScene make_scene(const std::vector<ref::Triangle>& triangles, int materials, std::uint32_t seed) {
    Random random(seed);
    TestScene scene;
    scene.triangles = triangles;
    scene.flat.shape_count = materials;
    for (int m = 0; m < materials; ++m) scene.flat.materials.push_back(random_material(random));
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const ref::Triangle& t = triangles[i];
        const dvec3 normal = glm::normalize(glm::cross(t.v1 - t.v0, t.v2 - t.v0));
        if (static_cast<std::size_t>(t.plane) == scene.flat.planes.size())
            scene.flat.planes.push_back(to_float4(normal, glm::dot(normal, t.v0)));
        const int shape = static_cast<int>(i) % materials, material = static_cast<int>(i) / 2 % materials;
        scene.flat.triangles.push_back({to_float4(t.v0), to_float4(t.v1), to_float4(t.v2), t.plane, material, shape, 0});
    }
    return scene;
}

/// Walls of [-h, h]^3 looking inward; planes 0 to 5.
inline std::vector<ref::Triangle> box_triangles(double h = 0.75) {
    std::vector<ref::Triangle> out;
    for (int wall = 0; wall < 6; ++wall) {
        const int axis = wall / 2;
        const double side = wall % 2 == 0 ? -1.0 : 1.0;
        const auto corner = [&](double u, double v) {
            dvec3 p;
            p[axis] = side * h;
            p[(axis + 1) % 3] = u * h * -side;  // counter-clockwise seen from inside
            p[(axis + 2) % 3] = v * h;
            return p;
        };
        out.push_back({corner(-1, -1), corner(1, -1), corner(1, 1), wall});
        out.push_back({corner(-1, -1), corner(1, 1), corner(-1, 1), wall});
    }
    return out;
}

inline TestScene soup_scene(std::uint32_t seed, int count, int materials = 5) {
    Random random(seed);
    return make_scene(ref::triangle_soup(random, count), materials, seed + 1);
}
inline TestScene box_scene(std::uint32_t seed) { return make_scene(box_triangles(), 12, seed); }

/// A room with things in it: inward box and soup of smaller triangles.
inline TestScene room_scene(std::uint32_t seed, int things) {
    Random random(seed);
    std::vector<ref::Triangle> triangles = box_triangles();
    for (ref::Triangle t : ref::triangle_soup(random, things)) {
        for (dvec3* corner : {&t.v0, &t.v1, &t.v2}) *corner = ref::as_float(*corner * 0.7);
        t.plane += 6;
        triangles.push_back(t);
    }
    return make_scene(triangles, 7, seed + 1);
}

inline Kernels make_kernels(bool smooth = false, Weights weights = Weights::dpdf, int cell_grid = 0, int film_samples = 4) {
    Features features;
    features.smooth = smooth;
    features.weights = kernel_weights(weights);
    features.cell_grid = cell_grid;
    features.film_samples = film_samples;
    return Kernels(device(), features);
}

/// kernels/shared/atlas.h: index of texel (x, y), gutter -1 and n, of a tile.
inline std::size_t atlas_index(int tile, int x, int y, int n) {
    const int stride = n + 2;
    return static_cast<std::size_t>(tile) * static_cast<std::size_t>(stride * stride) + static_cast<std::size_t>((y + 1) * stride + x + 1);
}

/// Texel of surfel i of a tile: blocks of 8 x 8 texels row by row, in a block patches 4 wide and 2 high row by row, in a patch row by row.
inline ref::Texel surfel_texel(int i, int n) {
    const int block = i / 64, patch = i / 8 % 8, in_patch = i % 8, blocks_across = n / 8;
    return {block % blocks_across * 8 + patch % 2 * 4 + in_patch % 4, block / blocks_across * 8 + patch / 2 * 2 + in_patch / 4};
}

inline std::vector<float4> random_centres(Random& random, int count, double half = 0.7) {
    std::vector<float4> out;
    out.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) out.push_back(to_float4(random.in_box(-half, half)));
    return out;
}

inline GeometryMaps rasterized(Kernels& kernels, const DeviceScene& scene, const std::vector<float4>& centres, int n) {
    GeometryMaps maps(device(), centres, n, "test");
    rasterize_octahedral(kernels, scene, maps, 0, static_cast<int>(centres.size()));
    return maps;
}

/// A read-back copy of surfels by field.
struct HostSurfels {
    explicit HostSurfels(const Surfels& surfels)
        : capacity(static_cast<std::size_t>(surfels.capacity)), count(surfels.count), data(surfels.data.read()) {}
    float at(int field, int i) const { return data[static_cast<std::size_t>(field) * capacity + static_cast<std::size_t>(i)]; }
    int bits(int field, int i) const {
        int out = 0;
        const float value = at(field, i);
        std::memcpy(&out, &value, sizeof out);
        return out;
    }
    dvec3 vector(int field, int i) const { return {at(field, i), at(field + 1, i), at(field + 2, i)}; }
    dvec3 position(int i) const { return vector(SURFEL_X, i); }
    dvec3 normal(int i) const { return vector(SURFEL_NX, i); }
    dvec3 face_normal(int i) const { return vector(SURFEL_GX, i); }
    dvec3 albedo(int i) const { return vector(SURFEL_ALBEDO_R, i); }
    int plane(int i) const { return bits(SURFEL_PLANE, i); }
    int material(int i) const { return bits(SURFEL_MATERIAL, i); }

    std::size_t capacity;
    int count;
    std::vector<float> data;
};

inline dvec3 rgb_at(const std::vector<float>& rgb, std::size_t capacity, int i) {
    const auto k = static_cast<std::size_t>(i);
    return {rgb[k], rgb[capacity + k], rgb[2 * capacity + k]};
}

/// Surfels seen by `viewers` centres through n x n texels each, cut to `limit` surfels.
inline Surfels gathered(Kernels& kernels, const DeviceScene& scene, const std::vector<float4>& viewers, int n, int limit) {
    const GeometryMaps maps = rasterized(kernels, scene, viewers, n);
    Surfels surfels(device(), static_cast<int>(viewers.size()) * n * n, "test surfels");
    gather_surfels(kernels, scene, maps, 0, maps.count, surfels);
    surfels.count = std::min(surfels.count, limit);
    return surfels;
}

/// Compares every component relative to the size of the expected vector; names index and both values.
inline void expect_close(const dvec3& got, const dvec3& expected, double relative, const std::string& what) {
    const double size = std::max({std::abs(expected.x), std::abs(expected.y), std::abs(expected.z)});
    for (int c = 0; c < 3; ++c) {
        ASSERT_LE(std::abs(got[c] - expected[c]), relative * size)
            << what << " component " << c << ": " << got[c] << " instead of " << expected[c];
    }
}

}  // namespace pencil::test
