// What the tests of the surface method's kernels share: surfels and pencils made by hand, on the host and on the device.
#pragma once

#include <set>

#include "kernels/kernel_test.h"
#include "reference/surface_pencil_ref.h"
#include "surface/surface_pencils.h"

namespace pencil::test {

/// Surfels written field by field.
class MadeSurfels {
public:
    explicit MadeSurfels(int surfel_count)
        : count(surfel_count),
          capacity(surfel_capacity(std::max(surfel_count, 1))),
          data(static_cast<std::size_t>(capacity) * SURFEL_FIELDS, 0.0F) {
        for (int i = 0; i < capacity; ++i) {
            set_bits(SURFEL_PLANE, i, -1);
            set_bits(SURFEL_MATERIAL, i, PENCIL_NO_MATERIAL);
        }
    }

    void set(int field, int i, float value) { data[index(field, i)] = value; }
    void set_bits(int field, int i, int value) { std::memcpy(&data[index(field, i)], &value, sizeof value); }
    void set_vector(int field, int i, const dvec3& v) {
        for (int c = 0; c < 3; ++c) set(field + c, i, static_cast<float>(v[c]));
    }
    /// A surfel of a plane, whose shading and geometric normals are `n`.
    void place(int i, const dvec3& x, const dvec3& n, int plane, const dvec3& albedo) {
        set_vector(SURFEL_X, i, x);
        set_vector(SURFEL_NX, i, n);
        set_vector(SURFEL_GX, i, n);
        set_vector(SURFEL_ALBEDO_R, i, albedo);
        set_bits(SURFEL_PLANE, i, plane);
        set_bits(SURFEL_MATERIAL, i, 0);
    }

    dvec3 vector(int field, int i) const { return {data[index(field, i)], data[index(field + 1, i)], data[index(field + 2, i)]}; }
    dvec3 position(int i) const { return vector(SURFEL_X, i); }
    dvec3 normal(int i) const { return vector(SURFEL_NX, i); }
    dvec3 albedo(int i) const { return vector(SURFEL_ALBEDO_R, i); }
    int bits(int field, int i) const {
        int out = 0;
        std::memcpy(&out, &data[index(field, i)], sizeof out);
        return out;
    }

    Surfels on_device() const {
        Surfels surfels(device(), capacity, "made surfels");
        surfels.count = count;
        surfels.data.write(data);
        return surfels;
    }

    int count, capacity;
    std::vector<float> data;

private:
    std::size_t index(int field, int i) const {
        return static_cast<std::size_t>(field) * static_cast<std::size_t>(capacity) + static_cast<std::size_t>(i);
    }
};

/// What texels see: fronts and backs of so many materials, anywhere, and sometimes nothing.
inline MadeSurfels seen_materials(Random& random, int count, int materials) {
    MadeSurfels surfels(count);
    for (int i = 0; i < count; ++i) {
        if (random.index(9) == 0) continue;
        surfels.place(i, random.in_box(-0.7, 0.7), random.direction(), 0, dvec3(0.5));
        const int m = random.index(materials);
        surfels.set_bits(SURFEL_MATERIAL, i, random.uniform() < 0.3 ? ~m : m);
    }
    return surfels;
}

/// Pencils in free space of [-0.7, 0.7]^3 that look anywhere.
inline std::vector<SurfacePencil> random_pencils(std::uint32_t seed, int count) {
    Random random(seed);
    std::vector<SurfacePencil> pencils;
    for (int i = 0; i < count; ++i) {
        const dvec3 normal = random.direction();
        SurfacePencil p{};
        p.position = to_float4(random.in_box(-0.7, 0.7));
        p.normal = to_float4(normal, 0.1);
        p.facing = to_float4(normal);
        p.plane = -1;  // in free space
        p.key = static_cast<uint>(i);
        pencils.push_back(p);
    }
    return pencils;
}

/// A surface with bumps and a step about y = 0: points, normals and pencils on it may stand for each other, or just not.
struct BumpySurface {
    explicit BumpySurface(std::uint32_t seed) : random(seed) {}

    dvec3 point() {
        return {random.uniform(-0.7, 0.7), random.uniform() < 0.1 ? 0.1 : random.uniform(-0.01, 0.01), random.uniform(-0.7, 0.7)};
    }
    dvec3 normal() {
        const double tilt = random.uniform() < 0.1 ? 1.5 : 0.2;
        return glm::normalize(dvec3(random.uniform(-tilt, tilt), 1.0, random.uniform(-tilt, tilt)));
    }
    /// `radius`: of use through a grid. Half of the sectors have something at the horizon.
    SurfacePencil pencil(const dvec3& x, double radius) {
        SurfacePencil p{};
        p.position = to_float4(x, random.uniform(0.05, 0.8));
        p.normal = to_float4(normal(), radius);
        p.facing = p.normal;
        p.facing.w = p.position.w;
        for (int s = 0; s < 2 * RING_SECTORS; ++s) {
            if (random.uniform() < 0.5) continue;
            p.horizon_x[s] = static_cast<float>(random.uniform(-8, 8));
            p.horizon_y[s] = static_cast<float>(random.uniform(-8, 8));
        }
        return p;
    }
    Random random;
};

inline SurfacePencils on_device(const std::vector<SurfacePencil>& pencils, int n = 4) {
    SurfacePencils set(device(), std::max(static_cast<int>(pencils.size()), 1), n);
    set.data.write(pencils);
    set.count = static_cast<int>(pencils.size());
    return set;
}

/// A scene in which nothing is in the way.
inline const DeviceScene& far_scene() {
    static const FlatScene flat = make_scene({{{90, 90, 90}, {91, 90, 90}, {90, 91, 90}, 0}}, 1, 1).flat;
    static const DeviceScene scene(device(), flat, build_bvh(flat.triangles));
    return scene;
}

inline std::vector<float4> random_irradiance(Random& random, std::size_t count) {
    std::vector<float4> out;
    for (std::size_t i = 0; i < count; ++i) out.push_back(to_float4(random.in_box(0.1, 4.0)));
    return out;
}

/// Rgb per surfel, everywhere `value`.
inline Buffer<float> filled_rgb(int capacity, float value) {
    return Buffer<float>(device(), std::vector<float>(static_cast<std::size_t>(capacity) * 3, value), "rgb");
}

/// A permutation of 0 .. count - 1.
inline std::vector<int> shuffled(Random& random, std::size_t count) {
    std::vector<int> order;
    for (std::size_t i = 0; i < count; ++i) order.push_back(static_cast<int>(i));
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[static_cast<std::size_t>(random.index(static_cast<int>(i)))]);
    return order;
}

}  // namespace pencil::test
