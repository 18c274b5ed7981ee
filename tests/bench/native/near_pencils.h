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

struct NearestPencil {
    int index = -1;
    float square = infinite;

    /// Takes pencil i if it is nearer and faces the same way with nothing between.
    void consider(const SurfacePencil* pencils, int i, const Vec3& x, const Vec3& n) {
        const SurfacePencil& p = pencils[i];
        const Vec3 step = x - xyz(p.position);
        const float distance = dot(step, step);
        if (distance >= square || dot(xyz(p.normal), n) < least_cosine || !clear_horizon(p, step)) return;
        square = distance;
        index = i;
    }
};

inline int entry_pencil(const float* block, int lane) {
    int index = 0;
    std::memcpy(&index, block + ENTRY_PENCIL * lane_count + lane, sizeof index);
    return index;
}

inline void link_block(const SurfacePencil* pencils, const float* block, const Vec3& x, const Vec3& n, NearPencils& near) {
    const auto field = [&](int f) { return load<vfloat>(block + f * lane_count); };
    const vfloat sx = x.x - field(ENTRY_X), sy = x.y - field(ENTRY_Y), sz = x.z - field(ENTRY_Z), radius = field(ENTRY_RADIUS);
    const vfloat nx = field(ENTRY_NX), ny = field(ENTRY_NY), nz = field(ENTRY_NZ);
    const vfloat distance = square_root(sx * sx + sy * sy + sz * sz), cosine = nx * n.x + ny * n.y + nz * n.z;
    const vfloat rise = sx * (nx + n.x) + sy * (ny + n.y) + sz * (nz + n.z);
    unsigned reached = lane_mask((distance < radius) & (cosine >= least_cosine));
    if (reached == 0) return;
    reached &= lane_mask(absolute(rise) <= 2.0F * most_slope * distance + position_error(x));
    const vfloat closeness = maximum((radius - distance) / (radius * radius), broadcast(0.0F)), weight = closeness * closeness * cosine;
    for (; reached != 0; reached &= reached - 1) {
        const int l = __builtin_ctz(reached), p = entry_pencil(block, l);
        if (weight[l] > near.weight[3] && clear_horizon(pencils[p], x - xyz(pencils[p].position))) insert(near, p, weight[l]);
    }
}

inline NearPencils near_pencils(const SurfacePencil* pencils, const GridView& grid, const Vec3& x, const Vec3& n) {
    const PencilGrid& g = grid.grid;
    const auto along = [](float from, float low, float scale) { return static_cast<int>(std::floor((from - low) * scale)); };
    const auto slot_at = [&](int level, float scale) {
        return PENCIL_GRID_SLOT(along(x.x, g.origin.x, scale), along(x.y, g.origin.y, scale), along(x.z, g.origin.z, scale), level,
                                g.slots);
    };
    const auto block_at = [&](int e) { return grid.entries + static_cast<std::size_t>(e) * ENTRY_FIELDS * lane_count; };
    NearPencils near;
    float scale = g.origin.w;
    for (int level = 0; level < g.levels; ++level, scale /= PENCIL_GRID_STEP) {
        const int slot = slot_at(level, scale);
        for (int e = grid.starts[slot]; e < grid.starts[slot + 1]; ++e) link_block(pencils, block_at(e), x, n, near);
        if (near.weight[3] >= scale * scale / (PENCIL_GRID_REACH * PENCIL_GRID_REACH)) break;
    }
    const float sum = near.weight[0] + near.weight[1] + near.weight[2] + near.weight[3];
    for (float& w : near.weight) w = sum > 0.0F ? w / sum : 0.0F;
    if (sum > 0.0F) return near;
    NearestPencil nearest;
    scale = g.origin.w;
    const auto in_cell = [&](const float* block, int l) {
        const float radius = block[ENTRY_RADIUS * lane_count + l], most = radius + 1.7321F / scale;
        const Vec3 step = x - xyz(pencils[entry_pencil(block, l)].position);
        return radius > 0.0F && dot(step, step) <= most * most;
    };
    for (int level = 0; level < g.levels; ++level, scale /= PENCIL_GRID_STEP)
        for (int slot = slot_at(level, scale), e = grid.starts[slot]; e < grid.starts[slot + 1]; ++e)
            for (int l = 0; l < lane_count; ++l)
                if (in_cell(block_at(e), l)) nearest.consider(pencils, entry_pencil(block_at(e), l), x, n);
    if (nearest.index < 0) {
        const auto count = static_cast<unsigned>(g.count), stride = count % PENCIL_GRID_STRIDE == 0 ? 1U : PENCIL_GRID_STRIDE;
        for (unsigned k = 0; k < count && (k < PENCIL_GRID_LOOK || nearest.index < 0); ++k)
            nearest.consider(pencils, static_cast<int>(std::uint64_t{k} * stride % count), x, n);
    }
    if (nearest.index < 0) return near;
    near.index[0] = nearest.index;
    near.index[1] = LINK_STANDS_IN;
    near.weight[0] = 1.0F;
    return near;
}

}  // namespace pencil::native
