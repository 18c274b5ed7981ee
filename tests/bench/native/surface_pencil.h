// What the native loops of the surface method share: frames, horizons, reuse (kernels/lib/surface_pencil.cl), scalar.
#pragma once

#include <cmath>
#include <limits>

#include "bench/native/simd.h"
#include "bench/native/surface.h"
#include "shared/film.h"

namespace pencil::native {

struct Vec3 {
    float x, y, z;
};
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline float dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 xyz(const float4& v) { return {v.x, v.y, v.z}; }
inline Vec3 vector_at(const SurfelsView& surfels, int field, int i) {
    return {surfels.field(field)[i], surfels.field(field + 1)[i], surfels.field(field + 2)[i]};
}
inline int int_at(const SurfelsView& surfels, int field, int i) {
    int out = 0;
    std::memcpy(&out, surfels.field(field) + i, sizeof out);
    return out;
}

inline void tangent_frame(const Vec3& n, Vec3& t, Vec3& b) {
    const float s = std::copysign(1.0F, n.z), k = -1.0F / (s + n.z), m = n.x * n.y * k;
    t = {1.0F + s * n.x * n.x * k, s * m, -s * n.x};
    b = {m, s + n.y * n.y * k, -n.y};
}
inline int ring_sector(float x, float y) { return (x < 0.0F ? 4 : 0) | (y < 0.0F ? 2 : 0) | (std::abs(x) < std::abs(y) ? 1 : 0); }

/// Texel of entry i of a hemisphere.
inline int texel_x(int i, int n) { return i / 16 % (n / 4) * 4 + i % 4; }
inline int texel_y(int i, int n) { return i / 16 / (n / 4) * 4 + i % 16 / 4; }

inline float position_error(const Vec3& x) { return 1e-6F * std::max(std::abs(x.x), std::max(std::abs(x.y), std::abs(x.z))); }

constexpr float least_cosine = 0.5F, most_slope = 0.4F, turn = 0.5F;
constexpr float infinite = std::numeric_limits<float>::infinity();

inline bool clear_horizon(const SurfacePencil& p, const Vec3& step) {
    Vec3 t, b;
    tangent_frame(xyz(p.normal), t, b);
    const float x = dot(step, t), y = dot(step, b);
    const int sector = ring_sector(x, y), next = sector + RING_SECTORS;
    return std::max(x * p.horizon_x[sector] + y * p.horizon_y[sector], x * p.horizon_x[next] + y * p.horizon_y[next]) < 1.0F;
}

/// Infinite where the pencil may not be used.
inline float reuse_distance(const SurfacePencil& p, const Vec3& x, const Vec3& n) {
    const Vec3 step = x - xyz(p.position), normal = xyz(p.normal);
    if (dot(normal, n) < least_cosine) return infinite;
    const float distance = std::sqrt(dot(step, step));
    if (distance < position_error(x)) return 0.0F;
    if (std::abs(dot(step, normal + n)) > 2.0F * most_slope * distance) return infinite;
    return clear_horizon(p, step) ? distance : infinite;
}
inline float reuse_error(const SurfacePencil& p, float distance, const Vec3& n) {
    return distance / p.facing.w + turn * std::sqrt(std::max(1.0F - dot(xyz(p.normal), n), 0.0F));
}

/// Line of a lattice, at 0, spacing, 2 spacing .. and size - 1, that is `steps` away from that at `from`; -1: there is none.
inline int line_away(int from, int steps, int spacing, int size) {
    const int place = (from + spacing - 1) / spacing + steps;
    return place >= 0 && place <= (size + spacing - 2) / spacing ? std::min(place * spacing, size - 1) : -1;
}

/// visit(pencil) for the pencils up to `reach` lattice points away from that of pixel (x, y).
template <typename Visit>
void visit_neighbours(const LatticeView& film, int x, int y, int reach, int spacing, const Visit& visit) {
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
            const int px = line_away(x, dx, spacing, film.width), py = line_away(y, dy, spacing, film.height);
            if (px >= 0 && py >= 0 && film.at[py * film.width + px] >= 0) visit(film.at[py * film.width + px]);
        }
}

/// visit(pencil, corner pixel's x and y, spacing) for the pencils at the lattice points about pixel (x, y).
template <typename Visit>
inline void visit_corners(const LatticeView& film, int x, int y, const Visit& visit) {
    for (int spacing = film.coarsest; spacing >= film.finest; spacing /= 2)
        for (int corner = 0; corner < 4; ++corner) {
            const int cx = std::min((x / spacing + (corner & 1)) * spacing, film.width - 1);
            const int cy = std::min((y / spacing + (corner >> 1)) * spacing, film.height - 1);
            if (spacing < film.coarsest && ((cx | cy) & (2 * spacing - 1)) == 0) continue;
            const int pencil = film.at[cy * film.width + cx];
            if (pencil >= 0) visit(pencil, cx, cy, spacing);
        }
}

}  // namespace pencil::native
