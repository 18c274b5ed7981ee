// One surfel at a time, vectors of pencils: the exponent is the same in all lanes, and sixteen pencils that the surfel does not see are
// left out at once.
#include <cmath>
#include <vector>

#include "bench/native/native.h"
#include "bench/native/octahedral.h"
#include "bench/native/parallel.h"

namespace pencil::native {
namespace {

constexpr int max_doublings = 9;

/// Centres, structure of arrays, padded with the last to a multiple of lane_count.
struct Centres {
    std::vector<float> x, y, z;
    Centres(const float4* cops, int count) {
        for (int i = 0; i < (count + lane_count - 1) / lane_count * lane_count; ++i) {
            const float4& c = cops[std::min(i, count - 1)];
            x.push_back(c.x);
            y.push_back(c.y);
            z.push_back(c.z);
        }
    }
};

/// log2 of the exponent for each number of visible pencils.
std::vector<int> doublings_table(int count) {
    std::vector<int> table;
    for (int seen = 0; seen <= count; ++seen)
        table.push_back(
            std::clamp(static_cast<int>(std::rint(std::log2(5.0F * std::cbrt(static_cast<float>(std::max(seen, 1)))))), 0, max_doublings));
    return table;
}

inline float sum_lanes(vfloat v) {
    float sum = 0;
    for (int l = 0; l < lane_count; ++l) sum += v[l];
    return sum;
}

template <int Doublings>
float density(const Centres& centres, int groups, const unsigned* seen, float x, float y, float z, float px, float py, float pz) {
    vfloat sum{};
    for (int g = 0; g < groups; ++g) {
        if (seen[g] == 0) continue;
        const vint visible = ((broadcast(static_cast<int>(seen[g])) >> lane_numbers()) & 1) != 0;
        const vfloat vx = load<vfloat>(centres.x.data() + g * lane_count) - x, vy = load<vfloat>(centres.y.data() + g * lane_count) - y,
                     vz = load<vfloat>(centres.z.data() + g * lane_count) - z;
        vfloat power = (px * vx + py * vy + pz * vz) * reciprocal_sqrt(vx * vx + vy * vy + vz * vz);
        power = minimum(maximum(power, broadcast(0.0F)), broadcast(1.0F));
        for (int k = 0; k < Doublings; ++k) power *= power;
        sum += floats(bits(power) & visible);
    }
    return sum_lanes(sum);
}

using Density = float (*)(const Centres&, int, const unsigned*, float, float, float, float, float, float);
constexpr Density densities[max_doublings + 1] = {density<0>, density<1>, density<2>, density<3>, density<4>,
                                                  density<5>, density<6>, density<7>, density<8>, density<9>};

}  // namespace

void estimate_density(const SurfelsView& surfels, const float4* cops, int count, const uint* mask, int first_tile, int n,
                      float4* radiance) {
    const Centres centres(cops, count);
    const std::vector<int> doublings = doublings_table(count);
    const int groups = (count + lane_count - 1) / lane_count;
    parallel_blocks(surfels.count, 64, [&](int first, int last) {
        std::vector<unsigned> seen(static_cast<std::size_t>(groups));
        for (int i = first; i < last; ++i) {
            const int tile = first_tile + i / (n * n);
            int visible = 0;
            for (int g = 0; g < groups; ++g) {
                const uint word = mask[static_cast<std::size_t>(g * lane_count / 32) * surfels.capacity + static_cast<std::size_t>(i)];
                seen[static_cast<std::size_t>(g)] = word >> (g * lane_count % 32) & all_lanes_set;
                visible += __builtin_popcount(seen[static_cast<std::size_t>(g)]);
            }
            seen[static_cast<std::size_t>(tile / lane_count)] &= ~(1U << (tile % lane_count));
            const float x = surfels.field(SURFEL_X)[i], y = surfels.field(SURFEL_Y)[i], z = surfels.field(SURFEL_Z)[i];
            const float px = cops[tile].x - x, py = cops[tile].y - y, pz = cops[tile].z - z;
            const float scale = 1.0F / std::sqrt(px * px + py * py + pz * pz);
            const float d = densities[doublings[static_cast<std::size_t>(visible)]](centres, groups, seen.data(), x, y, z, px * scale,
                                                                                    py * scale, pz * scale);
            radiance[static_cast<std::size_t>(tile) * static_cast<std::size_t>(PENCIL_TILE_TEXELS(n)) +
                     static_cast<std::size_t>(tile_index(surfel_texel(i % (n * n), n), n))]
                .w = 1.0F / (1.0F + d);
        }
    });
}

}  // namespace pencil::native
