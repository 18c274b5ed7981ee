#include "bench/native/native.h"
#include "bench/native/parallel.h"
#include "bench/native/visibility.h"

namespace pencil::native {
namespace {

constexpr int block_lanes = 128;
constexpr float inverse_pi = 0.318309886F;

struct Irradiance {
    vfloat r, g, b;
};

inline void aim(const SurfelVectors& s, const TileView& tile, const LightSample& light, Aimed& out) {
    const vfloat vx = s.x - tile.cop[0], vy = s.y - tile.cop[1], vz = s.z - tile.cop[2];
    out.weight = maximum(-(s.nx * vx + s.ny * vy + s.nz * vz), broadcast(0.0F));
    const vfloat rr = vx * vx + vy * vy + vz * vz;
    const bool area = light.position.w != 0.0F;
    if (area) out.weight *= maximum(light.normal.x * vx + light.normal.y * vy + light.normal.z * vz, broadcast(0.0F));
    out.faces = lane_mask(out.weight > 0.0F);
    if (out.faces == 0) return;
    // One division for both: weight / (r (rr + a)) of point lights, weight / (rr (rr + a)) of area lights.
    out.weight /= (area ? rr : rr * reciprocal_sqrt(rr)) * (rr + light.normal.w);
    aim_at(tile, vx, vy, vz, out);
}

inline void add_sample(const SurfelVectors& s, const TileView& tile, const LightSample& light, const Aimed& aimed, Irradiance& e) {
    if (aimed.faces == 0) return;
    const vfloat weight = floats(bits(aimed.weight) & lanes_of(visible_lanes(s, tile, aimed)));
    e.r += weight * light.emission.x;
    e.g += weight * light.emission.y;
    e.b += weight * light.emission.z;
}

}  // namespace

void light_surfels(const SceneView& scene, const SurfelsView& surfels, const LightSample* samples, const MapsView& maps, RgbView outgoing) {
    parallel_blocks(
        surfels.count, block_lanes,
        [&](int first, int) {
            constexpr int packets = block_lanes / lane_count;
            SurfelVectors s[packets];
            Irradiance e[packets] = {};
            for (int p = 0; p < packets; ++p) s[p] = load_surfels(surfels, first + p * lane_count);
            for (int i = 0; i < maps.count; ++i) {
                const TileView tile(scene, maps, i);
                Aimed aimed[packets];
                for (int p = 0; p < packets; ++p) aim(s[p], tile, samples[i], aimed[p]);
                for (int p = 0; p < packets; ++p) add_sample(s[p], tile, samples[i], aimed[p], e[p]);
            }
            for (int p = 0; p < packets; ++p) {
                const int at = first + p * lane_count;
                const vfloat irradiance[3] = {e[p].r, e[p].g, e[p].b};
                for (int c = 0; c < 3; ++c) {
                    float* out = outgoing.channel(c) + at;
                    store(load<vfloat>(out) + inverse_pi * irradiance[c] * load<vfloat>(surfels.field(SURFEL_ALBEDO_R + c) + at), out);
                }
            }
        });
}

}  // namespace pencil::native
