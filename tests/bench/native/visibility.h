// Exact visibility by geometry maps: the rules of kernels/lib/visibility.cl, for vectors of surfels.
#pragma once

#include "bench/native/octahedral.h"
#include "bench/native/triangle.h"

namespace pencil::native {

/// One tile of geometry maps with its scene.
struct TileView {
    const SceneView& scene;
    const Hit* hits;
    const glm::ivec2* cells;
    const glm::ivec4* groups;
    int n;
    float4v cop;

    TileView(const SceneView& s, const MapsView& maps, int tile)
        : scene(s),
          hits(maps.hits + static_cast<std::size_t>(tile) * maps.tile_texels()),
          cells(maps.cells + static_cast<std::size_t>(tile) * maps.tile_texels()),
          groups(maps.groups + static_cast<std::size_t>(tile) * maps.tile_texels()),
          n(maps.n),
          cop(load_point(maps.cops[tile])) {}
};

struct SurfelVectors {
    vfloat x, y, z, nx, ny, nz;
    vint plane;
};

inline SurfelVectors load_surfels(const SurfelsView& surfels, int first) {
    const auto field = [&](int f) { return load<vfloat>(surfels.field(f) + first); };
    return {field(SURFEL_X),
            field(SURFEL_Y),
            field(SURFEL_Z),
            field(SURFEL_NX),
            field(SURFEL_NY),
            field(SURFEL_NZ),
            load<vint>(surfels.field(SURFEL_PLANE) + first)};
}

/// Bits of the lanes of `lanes` that are seen although no cell or plane settles them: tested exactly against the triangles about their
/// footprints, all lanes with the same triangles at once.
unsigned settle_mixed(const SurfelVectors& s, const TileView& tile, const Footprints& f, const int* index, unsigned lanes);

/// Lanes that lie behind the plane `blocker` as seen from the centre.
inline unsigned behind_plane(const SurfelVectors& s, const TileView& tile, int blocker) {
    float4v plane = load4(tile.scene.planes[blocker]);
    if (plane_ahead(tile.scene.planes[blocker], tile.cop) <= 0.0F) plane = -plane;
    return lane_mask(plane[3] - (plane[0] * s.x + plane[1] * s.y + plane[2] * s.z) <= -plane_tolerance);
}

/// Bits of the lanes in `open`, which their cells (first, second) do not show, that are seen nevertheless. Lanes with the same blocking
/// plane are settled at once; what lies behind the other plane of a pair, or sees three planes, is left to settle_mixed.
inline unsigned settle_open(const SurfelVectors& s, const TileView& tile, const Footprints& f, const int* index, vint first, vint second,
                            unsigned open) {
    const vint pair = CELL_PAIR(second);
    const vint filled = (first == second) & (first >= 0);
    vint blocker = (filled | (pair == s.plane)) != 0 ? first : broadcast(CELL_MIXED);
    blocker = ((first == s.plane) & (second <= CELL_PAIR(0))) != 0 ? pair : blocker;
    const unsigned filled_lanes = lane_mask(filled);
    unsigned seen = 0, exact = open & lane_mask(blocker < 0);
    for (unsigned rest = open & ~exact; rest != 0;) {
        const int plane = blocker[__builtin_ctz(rest)];
        const unsigned same = rest & lane_mask(blocker == plane), behind = behind_plane(s, tile, plane);
        seen |= same & ~behind;
        exact |= same & behind & ~filled_lanes;
        rest &= ~same;
    }
    return exact == 0 ? seen : seen | settle_mixed(s, tile, f, index, exact);
}

/// A vector of surfels as a tile meets it. A whole block is aimed before its visibility is tested, so that the memory which the tests
/// need is on its way: the maps of a set are larger than the near caches.
struct Aimed {
    Footprints f;
    vfloat weight;
    alignas(64) int index[lane_count];  // f.index in memory
    unsigned faces = 0;                 // bits of the lanes that face the centre
};

/// Footprints of the directions v; neighbouring lanes mostly share the line of their cells.
inline void aim_at(const TileView& tile, vfloat vx, vfloat vy, vfloat vz, Aimed& out) {
    out.f = footprints(vx, vy, vz, tile.n);
    store(out.f.index, out.index);
    for (int l = 0; l < lane_count; l += 2) __builtin_prefetch(tile.cells + out.index[l]);
}

/// Bits of the lanes that the centre of `tile` sees.
inline unsigned visible_lanes(const SurfelVectors& s, const TileView& tile, const Aimed& aimed) {
    if (aimed.faces == 0) return 0;
    vint first, second;
    gather_pairs(tile.cells, aimed.index, first, second);
    const unsigned seen = aimed.faces & lane_mask(((first == s.plane) | (second == s.plane)) & (second >= -1));
    const unsigned open = aimed.faces & ~seen;
    return open == 0 ? seen : seen | settle_open(s, tile, aimed.f, aimed.index, first, second, open);
}

/// -1 in the lanes of `mask`.
inline vint lanes_of(unsigned mask) { return ((broadcast(static_cast<int>(mask)) >> lane_numbers()) & 1) != 0; }

}  // namespace pencil::native
