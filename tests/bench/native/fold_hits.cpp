// What footprints show (kernels/fold_hits.cl). Most are filled by one plane, so that is decided first, from the planes of a whole row of
// texels; the rest is scalar.
#include <cmath>
#include <utility>

#include "bench/native/native.h"
#include "bench/native/octahedral.h"
#include "bench/native/parallel.h"
#include "bench/native/triangle.h"

namespace pencil::native {
namespace {

struct Tile {
    const SceneView& scene;
    const Hit* hits;  // gutters filled
    int n;
    float4v cop;

    int shown(int triangle) const { return triangle < 0 ? -1 : scene.triangles[triangle].plane; }
    float disparity(int plane, float4v direction) const {
        const float4& p = scene.planes[plane];
        return dot3(load4(p), direction) / plane_ahead(p, cop);
    }
};

struct Footprint {
    int shown[4];
    float4v directions[4];
};

/// True if surfels on the plane of corner a can be hidden by that of corner b.
bool plane_hides(const Tile& tile, const Footprint& f, int a, int b) {
    for (int k = 0; k < 4; ++k)
        if (f.shown[k] == f.shown[b] && tile.disparity(f.shown[b], f.directions[k]) >= tile.disparity(f.shown[a], f.directions[k]))
            return true;
    return false;
}

/// The first triangle of each group of mates that the footprint and the texels next to it show, ascending; see kernels/fold_hits.cl.
glm::ivec4 groups_around(const Tile& tile, Texel corner) {
    int low[4] = {-1, -1, -1, -1}, inner[4] = {}, high[4] = {}, count = 0;
    for (int k = 0; k < 16; ++k) {
        const int triangle = tile.hits[tile_index(fold_texel({corner.x + k % 4 - 1, corner.y + k / 4 - 1}, tile.n), tile.n)].triangle;
        if (triangle < 0) continue;
        int g = 0;
        while (g < count && (triangle < low[g] || triangle > high[g])) ++g;
        if (g == 4) return glm::ivec4(CELL_MIXED);
        if (g == count) {
            ++count;
            low[g] = triangle - (tile.scene.triangles[triangle].mates & 0xff);
            high[g] = triangle + (tile.scene.triangles[triangle].mates >> 8);
        }
        if (k == 5 || k == 6 || k == 9 || k == 10) inner[g] = GROUP_INNER;
    }
    for (int g = 0; g < 4; ++g) low[g] = low[g] < 0 ? low[g] : low[g] | inner[g];
    for (int end = count; end > 1; --end)
        for (int g = 1; g < end; ++g)
            if ((low[g] & ~GROUP_INNER) < (low[g - 1] & ~GROUP_INNER)) std::swap(low[g], low[g - 1]);
    return {low[0], low[1], low[2], low[3]};
}

/// True if plane t is nearer than a and b somewhere on the border of the footprint.
bool reaches_between(const Tile& tile, const Footprint& f, int t, int a, int b) {
    const int around[5] = {0, 1, 3, 2, 0};
    for (int side = 0; side < 4; ++side) {
        const float4v from = f.directions[around[side]], to = f.directions[around[side + 1]];
        const float low_a = tile.disparity(t, from) - tile.disparity(a, from), low_b = tile.disparity(t, from) - tile.disparity(b, from);
        const float high_a = tile.disparity(t, to) - tile.disparity(a, to), high_b = tile.disparity(t, to) - tile.disparity(b, to);
        if (std::fmin(low_a, low_b) > 0.0F || std::fmin(high_a, high_b) > 0.0F) return true;
        if (std::fmax(low_a, high_a) <= 0.0F || std::fmax(low_b, high_b) <= 0.0F) continue;
        const float zero_a = low_a / (low_a - high_a), zero_b = low_b / (low_b - high_b);
        if ((low_a <= 0.0F ? zero_a : zero_b) <= (low_a <= 0.0F ? zero_b : zero_a)) return true;
    }
    return false;
}

/// Cell of a footprint that shows exactly two planes, those of corners a and b.
glm::ivec2 two_planes(const Tile& tile, const Footprint& f, int a, int b, const glm::ivec4& around) {
    glm::ivec2 cell(f.shown[a], f.shown[b]);
    if (cell.x < 0 || cell.y < 0) return cell;
    const bool hides_a = plane_hides(tile, f, a, b), hides_b = plane_hides(tile, f, b, a);
    if (!hides_a && !hides_b) return cell;
    if (hides_a && hides_b) {
        if (around.x == CELL_MIXED) return glm::ivec2(CELL_MIXED);
        for (int g = 0; g < 4 && around[g] >= 0; ++g) {
            const int third = tile.shown(around[g] & ~GROUP_INNER);
            if (third != cell.x && third != cell.y && reaches_between(tile, f, third, cell.x, cell.y)) return glm::ivec2(CELL_MIXED);
        }
    }
    cell.y = CELL_PAIR(cell.y);
    return cell;
}

void classify(const Tile& tile, Texel corner, const int* shown, glm::ivec2& cell, glm::ivec4& groups) {
    Footprint f{};
    int b = 0, others = 0;
    for (int k = 0; k < 4; ++k) {
        f.shown[k] = shown[k];
        f.directions[k] = texel_direction(fold_texel({corner.x + (k & 1), corner.y + (k >> 1)}, tile.n), tile.n);
        if (shown[k] != shown[0]) b = k;
    }
    for (int k = 0; k < 4; ++k) others += shown[k] != shown[0] && shown[k] != shown[b] ? 1 : 0;
    groups = groups_around(tile, corner);
    cell = others > 0 ? glm::ivec2(CELL_MIXED) : two_planes(tile, f, 0, b, groups);
}

void fill_gutter(Hit* hits, int n) {
    const auto fill = [&](int x, int y) { hits[tile_index({x, y}, n)] = hits[tile_index(fold_texel({x, y}, n), n)]; };
    for (int k = -1; k <= n; ++k) {
        fill(k, -1);
        fill(k, n);
        fill(-1, k);
        fill(n, k);
    }
}

}  // namespace

void fold_hits(const SceneView& scene, const float4* cops, int count, int n, Hit* hits, glm::ivec2* cells, glm::ivec4* groups) {
    const int stride = PENCIL_TILE_STRIDE(n);
    parallel_blocks(count, 1, [&](int t, int) {
        const std::size_t at = static_cast<std::size_t>(t) * static_cast<std::size_t>(PENCIL_TILE_TEXELS(n));
        fill_gutter(hits + at, n);
        const Tile tile{scene, hits + at, n, load_point(cops[t])};
        thread_local std::vector<int> upper, lower;
        upper.resize(static_cast<std::size_t>(stride));
        lower.resize(upper.size());
        const auto planes_of_row = [&](int row, std::vector<int>& planes) {
            for (int x = 0; x < stride; ++x) planes[static_cast<std::size_t>(x)] = tile.shown(tile.hits[row * stride + x].triangle);
        };
        planes_of_row(0, upper);
        for (int y = 0; y <= n; ++y) {
            planes_of_row(y + 1, lower);
            for (int x = 0; x <= n; ++x) {
                const auto c = static_cast<std::size_t>(x);
                const std::size_t target = at + static_cast<std::size_t>(y * stride + x);
                const int shown[4] = {upper[c], upper[c + 1], lower[c], lower[c + 1]};
                if (shown[0] == shown[1] && shown[0] == shown[2] && shown[0] == shown[3]) {
                    cells[target] = glm::ivec2(shown[0]);
                    groups[target] = glm::ivec4(-1);
                } else {
                    classify(tile, {x - PENCIL_GUTTER, y - PENCIL_GUTTER}, shown, cells[target], groups[target]);
                }
            }
            std::swap(upper, lower);
        }
    });
}

}  // namespace pencil::native
