// The pencils near a point by the grid (kernels/lib/pencil_grid.cl): a vector of entries at a time.
#pragma once

#include "bench/native/surface_pencil.h"

namespace pencil::native {

struct NearPencils {
    int index[4] = {-1, -1, -1, -1};
    float weight[4] = {};
};

inline void insert(NearPencils& near, int index, float weight) {
    for (int k = 0; k < 4; ++k)
        if (weight > near.weight[k]) {
            std::swap(weight, near.weight[k]);
            std::swap(index, near.index[k]);
        }
}

inline vfloat square_root(vfloat v) {
#ifdef __AVX512F__
    return _mm512_sqrt_ps(v);
#else
    vfloat out;
    for (int l = 0; l < lane_count; ++l) out[l] = std::sqrt(v[l]);
    return out;
#endif
}

inline NearPencils near_pencils(const SurfacePencil* pencils, const GridView& grid, const Vec3& x, const Vec3& n) {
    const PencilGrid& g = grid.grid;
    const auto along = [](float from, float low, float scale) { return static_cast<int>(std::floor((from - low) * scale)); };
    NearPencils near;
    float least = infinite;
    int last = -1;
    const auto link = [&](int e) {
        const float* block = grid.entries + static_cast<std::size_t>(e) * ENTRY_FIELDS * lane_count;
        const auto field = [&](int f) { return load<vfloat>(block + f * lane_count); };
        const vfloat sx = x.x - field(ENTRY_X), sy = x.y - field(ENTRY_Y), sz = x.z - field(ENTRY_Z), radius = field(ENTRY_RADIUS);
        const vfloat nx = field(ENTRY_NX), ny = field(ENTRY_NY), nz = field(ENTRY_NZ);
        const vfloat distance = square_root(sx * sx + sy * sy + sz * sz), cosine = nx * n.x + ny * n.y + nz * n.z;
        const vfloat rise = sx * (nx + n.x) + sy * (ny + n.y) + sz * (nz + n.z);
        const unsigned reached = lane_mask((distance < radius) & (cosine >= least_cosine));
        if (reached == 0) return;
        const unsigned level = reached & lane_mask(absolute(rise) <= 2.0F * most_slope * distance + position_error(x));
        const vfloat closeness = maximum((radius - distance) / (radius * radius), broadcast(0.0F)), weight = closeness * closeness * cosine;
        const auto pencil_at = [&](int l) {
            int index = 0;
            std::memcpy(&index, block + ENTRY_PENCIL * lane_count + l, sizeof index);
            return index;
        };
        for (unsigned rest = level; rest != 0; rest &= rest - 1) {
            const int l = __builtin_ctz(rest), p = pencil_at(l);
            if (weight[l] > near.weight[3] && clear_horizon(pencils[p], x - xyz(pencils[p].position))) insert(near, p, weight[l]);
        }
        for (unsigned rest = near.index[0] < 0 ? reached : 0U; rest != 0; rest &= rest - 1) {
            const int l = __builtin_ctz(rest), p = pencil_at(l);
            if (distance[l] >= least || !clear_horizon(pencils[p], x - xyz(pencils[p].position))) continue;
            least = distance[l];
            last = p;
        }
    };
    float scale = g.origin.w;
    for (int level = 0; level < g.levels; ++level, scale *= 0.5F) {
        const int slot =
            PENCIL_GRID_SLOT(along(x.x, g.origin.x, scale), along(x.y, g.origin.y, scale), along(x.z, g.origin.z, scale), level, g.slots);
        for (int e = grid.starts[slot]; e < grid.starts[slot + 1]; ++e) link(e);
        if (near.weight[3] >= scale * scale / (PENCIL_GRID_REACH * PENCIL_GRID_REACH)) break;
    }
    const bool alone = near.weight[0] <= 0.0F && last < 0;
    float least_ratio = infinite;
    for (int k = 0; alone && k < g.count; ++k) {
        const SurfacePencil& p = pencils[k];
        const Vec3 step = x - xyz(p.position);
        const float ratio = dot(step, step) / (p.normal.w * p.normal.w);
        if (ratio >= least_ratio || dot(xyz(p.normal), n) < least_cosine) continue;
        least_ratio = ratio;
        last = k;
    }
    const float sum = near.weight[0] + near.weight[1] + near.weight[2] + near.weight[3];
    for (float& w : near.weight) w = sum > 0.0F ? w / sum : 0.0F;
    if (sum == 0.0F && last >= 0) {
        near.index[0] = last;
        near.index[1] = LINK_LAST_RESORT;
        near.weight[0] = 1.0F;
    }
    return near;
}

}  // namespace pencil::native
