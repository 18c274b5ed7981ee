#include "bench/native/hash.h"
#include "bench/native/parallel.h"
#include "bench/native/rays.h"
#include "bench/native/surface.h"

namespace pencil::native {
namespace {

constexpr int most_vectors = 16 / lane_count + 1;  // of a packet of at most 16 surfels
constexpr float inverse_pi = 0.318309886F;
constexpr float even = 0.25F;  // of the draws

/// Surfels that draw together: their first lanes in vectors, the others masked.
struct Packet {
    SurfelVectors s[most_vectors];
    vint mask[most_vectors];
    int first, vectors;

    Packet(const SurfelsView& surfels, int first_surfel, int width) : first(first_surfel), vectors((width + lane_count - 1) / lane_count) {
        for (int k = 0; k < vectors; ++k) {
            s[k] = load_surfels(surfels, first + k * lane_count);
            mask[k] = lane_numbers() < width - k * lane_count;
        }
    }
};

inline vfloat sample_weight(const SurfelVectors& s, const LightSample& light, vint mask) {
    const vfloat vx = s.x - light.position.x, vy = s.y - light.position.y, vz = s.z - light.position.z, zero{};
    const bool area = light.position.w != 0.0F;
    vfloat weight = maximum(-(s.nx * vx + s.ny * vy + s.nz * vz), zero);
    const vfloat rr = vx * vx + vy * vy + vz * vz;
    if (area) weight *= maximum(light.normal.x * vx + light.normal.y * vy + light.normal.z * vz, zero);
    weight /= (area ? rr : rr * reciprocal_sqrt(rr)) * (rr + light.normal.w);
    return ((weight > 0.0F) & mask) ? weight : zero;
}

inline float sum_of(vfloat v) {
    float sum = 0.0F;
    for (int l = 0; l < lane_count; ++l) sum += v[l];
    return sum;
}

inline float importance(const Packet& p, const LightSample& light) {
    float sum = 0.0F;
    for (int k = 0; k < p.vectors; ++k) sum += sum_of(sample_weight(p.s[k], light, p.mask[k]));
    return sum * (light.emission.x + light.emission.y + light.emission.z);
}

inline void add(const Packet& p, const SceneView& scene, const BvhView& bvh, const SurfelsView& surfels, const LightSample& light,
                float scale, RgbView outgoing) {
    for (int k = 0; k < p.vectors; ++k) {
        const vfloat weight = sample_weight(p.s[k], light, p.mask[k]);
        const unsigned lit = unhidden(p.s[k], load_point(light.position), scene, bvh, lane_mask(weight > 0.0F));
        if (lit == 0) continue;
        const vfloat e = floats(bits(weight) & lanes_of(lit)) * (scale * inverse_pi);
        const int at = p.first + k * lane_count;
        for (int c = 0; c < 3; ++c) {
            float* out = outgoing.channel(c) + at;
            const float* albedo = surfels.field(SURFEL_ALBEDO_R + c) + at;
            for (int l = 0; l < lane_count; ++l)
                if ((lit >> l & 1U) != 0) out[l] += e[l] * light.emission[c] * albedo[l];
        }
    }
}

}  // namespace

void sample_lights(const SceneView& scene, const BvhView& bvh, const SurfelsView& surfels, const LightSample* samples, int sample_count,
                   int width, int stride, int draws, uint seed, RgbView outgoing) {
    const int packets = (surfels.count + width - 1) / width;
    parallel_blocks(packets, 16, [&](int begin, int end) {
        std::vector<float> shares(static_cast<std::size_t>(sample_count));
        for (int packet = begin; packet < end; ++packet) {
            const Packet p(surfels, packet * width, width);
            const unsigned random = hash_uint(static_cast<unsigned>(packet * width) ^ seed);
            const int start = 3 * static_cast<int>(random % static_cast<unsigned>(stride));
            const auto for_candidates = [&](const auto& visit) {
                for (int three = start; three < sample_count; three += 3 * stride)
                    for (int i = three; i < std::min(three + 3, sample_count); ++i) visit(static_cast<std::size_t>(i));
            };
            float total = 0.0F, sum = 0.0F;
            int reaching = 0;
            for_candidates([&](std::size_t i) {
                total += shares[i] = importance(p, samples[i]);
                reaching += shares[i] > 0.0F ? 1 : 0;
            });
            if (!(total > 0.0F)) continue;
            const float share = even * total / static_cast<float>(reaching);
            const float interval = total / static_cast<float>(draws);
            float next = interval * unit(hash_uint(random));
            for_candidates([&](std::size_t i) {
                if (!(shares[i] > 0.0F)) return;
                sum += shares[i] = (1.0F - even) * shares[i] + share;
                int drawn = 0;
                for (; next < sum; next += interval) ++drawn;
                if (drawn != 0)
                    add(p, scene, bvh, surfels, samples[i], static_cast<float>(drawn) * interval / shares[i] * static_cast<float>(stride),
                        outgoing);
            });
        }
    });
}

}  // namespace pencil::native
