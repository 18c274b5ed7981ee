// The footprints that no cell settles: few, and scalar.
#include "bench/native/visibility.h"

#include <cmath>

namespace pencil::native {
namespace {

bool segment_crosses(const TileView& tile, int index, float4v x) {
    const Triangle* triangle = tile.scene.triangles + index;
    const float4& plane = tile.scene.planes[triangle->plane];
    const float cop_ahead = plane_ahead(plane, tile.cop), x_ahead = plane_ahead(plane, x);
    if (cop_ahead * x_ahead >= 0.0F || std::abs(x_ahead) < plane_tolerance) return false;
    for (int t = -(triangle->mates & 0xff); t <= triangle->mates >> 8; ++t)
        if (line_meets_triangle(triangle[t], tile.cop, x - tile.cop, cop_ahead > 0.0F ? 1.0F : -1.0F)) return true;
    return false;
}

float hiding_weight(const TileView& tile, Texel corner, float fx, float fy, float4v x, int own) {
    const float4& own_plane = tile.scene.planes[own];
    const float own_side = plane_ahead(own_plane, tile.cop) > 0.0F ? 1.0F : -1.0F;
    float hidden = 0.0F;
    for (int k = 0; k < 4; ++k) {
        const Texel texel = fold_texel({corner.x + (k & 1), corner.y + (k >> 1)}, tile.n);
        const Hit& hit = tile.hits[tile_index(texel, tile.n)];
        if (hit.triangle < 0) continue;
        const float4& plane = tile.scene.planes[tile.scene.triangles[hit.triangle].plane];
        const float x_ahead = plane_ahead(plane, x);
        if (plane_ahead(plane, tile.cop) * x_ahead >= 0.0F || std::abs(x_ahead) < plane_tolerance) continue;
        const float4v seen = tile.cop + texel_direction(texel, tile.n) / hit.disparity;
        if (plane_ahead(own_plane, seen) * own_side > plane_tolerance)
            hidden += ((k & 1) != 0 ? fx : 1.0F - fx) * ((k >> 1) != 0 ? fy : 1.0F - fy);
    }
    return hidden;
}

bool crowded_footprint_visible(const TileView& tile, Texel corner, float fx, float fy, float4v x, int own) {
    bool shown = false;
    for (int k = 0; k < 16; ++k) {
        const Texel texel = fold_texel({corner.x + k % 4 - 1, corner.y + k / 4 - 1}, tile.n);
        const int triangle = tile.hits[tile_index(texel, tile.n)].triangle;
        if (triangle < 0) continue;
        if (tile.scene.triangles[triangle].plane == own)
            shown = shown || k == 5 || k == 6 || k == 9 || k == 10;
        else if (segment_crosses(tile, triangle, x))
            return false;
    }
    return shown || hiding_weight(tile, corner, fx, fy, x, own) <= 0.5F;
}

/// Lanes whose line from the centre passes through the triangle or its border; v: x minus the centre.
unsigned meets_triangle(const TileView& tile, const Triangle& t, float side, vfloat vx, vfloat vy, vfloat vz) {
    const float4v a = load_point(t.v0) - tile.cop, b = load_point(t.v1) - tile.cop, c = load_point(t.v2) - tile.cop;
    const float4v ab = edge_normal(a, b) * side, bc = edge_normal(b, c) * side, ca = edge_normal(c, a) * side;
    const auto inside = [&](float4v e) { return e[0] * vx + e[1] * vy + e[2] * vz; };
    return lane_mask(minimum(minimum(inside(ab), inside(bc)), inside(ca)) >= 0.0F);
}

/// Those of `lanes` whose segment crosses the group of mates that begins with triangle `first`.
unsigned crosses(const SurfelVectors& s, const TileView& tile, int first, unsigned lanes) {
    const Triangle* t = tile.scene.triangles + first;
    const float ahead = plane_ahead(tile.scene.planes[t->plane], tile.cop);
    lanes &= behind_plane(s, tile, t->plane);
    if (lanes == 0 || ahead == 0.0F) return 0;
    const vfloat vx = s.x - tile.cop[0], vy = s.y - tile.cop[1], vz = s.z - tile.cop[2];
    unsigned crossing = 0;
    int last = t->mates >> 8;
    last += t[last].mates >> 8;
    for (int k = 0; k <= last; ++k) crossing |= meets_triangle(tile, t[k], ahead > 0.0F ? 1.0F : -1.0F, vx, vy, vz);
    return crossing & lanes;
}

/// Those of `lanes` that are seen past `group`, the triangles about each of their footprints; `inner`: for each lane, bits of the groups
/// that the footprint itself shows.
unsigned seen_past(const SurfelVectors& s, const TileView& tile, const Footprints& f, const int* group, const unsigned* inner,
                   unsigned lanes) {
    unsigned shown = 0;
    for (int g = 0; g < 4 && group[g] >= 0 && lanes != 0; ++g) {
        const unsigned own = lanes & lane_mask(s.plane == tile.scene.triangles[group[g]].plane);
        shown |= own & inner[g];
        if (own != lanes) lanes &= ~crosses(s, tile, group[g], lanes & ~own);
    }
    for (unsigned unsure = lanes & ~shown; unsure != 0; unsure &= unsure - 1) {
        const int l = __builtin_ctz(unsure);
        const float4v x{s.x[l], s.y[l], s.z[l], 0.0F};
        if (hiding_weight(tile, {f.x[l] - PENCIL_GUTTER, f.y[l] - PENCIL_GUTTER}, f.fx[l], f.fy[l], x, s.plane[l]) > 0.5F)
            lanes &= ~(1U << l);
    }
    return lanes;
}

}  // namespace

unsigned settle_mixed(const SurfelVectors& s, const TileView& tile, const Footprints& f, const int* index, unsigned lanes) {
    unsigned seen = 0;
    while (lanes != 0) {
        const int lead = __builtin_ctz(lanes);
        const int4v first = load<int4v>(tile.groups + index[lead]);
        if (first[0] == CELL_MIXED) {
            lanes &= lanes - 1;
            const float4v x{s.x[lead], s.y[lead], s.z[lead], 0.0F};
            const Texel corner{f.x[lead] - PENCIL_GUTTER, f.y[lead] - PENCIL_GUTTER};
            if (crowded_footprint_visible(tile, corner, f.fx[lead], f.fy[lead], x, s.plane[lead])) seen |= 1U << lead;
            continue;
        }
        int group[4];
        for (int g = 0; g < 4; ++g) group[g] = GROUP_TRIANGLE(first[g]);
        unsigned alike = 0, inner[4] = {};
        for (unsigned rest = lanes; rest != 0; rest &= rest - 1) {
            const int l = __builtin_ctz(rest);
            const int4v about = load<int4v>(tile.groups + index[l]), difference = about ^ first;
            const int4v triangles = difference & ~GROUP_INNER;
            if ((triangles[0] | triangles[1] | triangles[2] | triangles[3]) != 0) continue;
            alike |= 1U << l;
            for (int g = 0; g < 4; ++g) inner[g] |= static_cast<unsigned>((about[g] & GROUP_INNER) != 0) << l;
        }
        lanes &= ~alike;
        seen |= seen_past(s, tile, f, group, inner, alike);
    }
    return seen;
}

}  // namespace pencil::native
