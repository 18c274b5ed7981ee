#include "line/field_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/vec2.hpp>
#include <limits>

#include "util/error.h"

namespace pencil {

namespace {

/// Centres may lie outside by so much of the box: rounding.
constexpr double slack = 1e-4;
/// What a hostile file may hold of light, on the device: sums of it are finite.
constexpr double most_light = 1e30;

/// oct_fold_texel of kernels/lib/octahedral.cl.
glm::ivec2 folded(glm::ivec2 t, int n) {
    if (t.x < 0 || t.x >= n) t = {t.x < 0 ? -1 - t.x : 2 * n - 1 - t.x, n - 1 - t.y};
    if (t.y < 0 || t.y >= n) t = {n - 1 - t.x, t.y < 0 ? -1 - t.y : 2 * n - 1 - t.y};
    return t;
}

/// oct_antipode of kernels/lib/octahedral.cl: light that is seen through a texel travels on through its antipode.
glm::ivec2 antipode(const glm::ivec2& t, int n) {
    const int half = n / 2;
    const int kx = t.x >= half ? t.x - half : half - 1 - t.x, ky = t.y >= half ? t.y - half : half - 1 - t.y;
    const int ax = half - 1 - ky, ay = half - 1 - kx;
    return {t.x >= half ? half - 1 - ax : half + ax, t.y >= half ? half - 1 - ay : half + ay};
}

std::size_t atlas_index(int tile, const glm::ivec2& t, int n) {
    const auto stride = static_cast<std::size_t>(PENCIL_TILE_STRIDE(n));
    return static_cast<std::size_t>(tile) * stride * stride + static_cast<std::size_t>(t.y + PENCIL_GUTTER) * stride +
           static_cast<std::size_t>(t.x + PENCIL_GUTTER);
}

/// A texel of a tile on the device, gutters too.
struct FieldTexel {
    std::size_t at, inside;  // itself, and the interior texel that it repeats, in the tile
    std::size_t light;       // the first value of the texel of the field's tile that its light is in, from the tile's first value on
};

std::vector<FieldTexel> texels_of(const PencilField& field) {
    const int n = field.map;
    std::vector<FieldTexel> texels;
    for (int y = -1; y <= n; ++y)
        for (int x = -1; x <= n; ++x) {
            const glm::ivec2 inside = folded({x, y}, n), seen = antipode(inside, n);
            texels.push_back({atlas_index(0, {x, y}, n), atlas_index(0, inside, n), field.index(0, seen.x, seen.y)});
        }
    return texels;
}

/// Calls `work(index, inside, light)` for all texels of the atlas: its index, that of the interior texel which it repeats, and its light.
template <typename Work>
void for_texels(const PencilField& field, double unit, const Work& work) {
    const std::vector<FieldTexel> texels = texels_of(field);
    for (int tile = 0; tile < field.count(); ++tile) {
        const float* const first = &field.light[field.index(tile, 0, 0)];
        const std::size_t target = static_cast<std::size_t>(tile) * texels.size();
        for (const FieldTexel& t : texels) {
            const auto on_device = [&](std::size_t c) {
                return static_cast<float>(std::min(static_cast<double>(first[t.light + c]) / unit, most_light));
            };
            work(target + t.at, target + t.inside, glm::vec3(on_device(0), on_device(1), on_device(2)));
        }
    }
}

}  // namespace

std::vector<float4> field_centres(const PencilField& field, const FlatScene& flat) {
    const glm::dvec3 margin = slack * (flat.high - flat.low) + glm::dvec3(slack);
    std::vector<float4> centres;
    for (const glm::dvec3& world : field.centres) {
        const glm::dvec3 c = flat.normalisation.to_scene(world);
        for (int k = 0; k < 3; ++k)
            if (!(c[k] >= flat.low[k] - margin[k] && c[k] <= flat.high[k] + margin[k]))
                throw UsageError(
                    fmt::format("--field: pencil {} at ({:g}, {:g}, {:g}) lies outside of the scene; was the field baked from it?",
                                centres.size(), world.x, world.y, world.z));
        centres.emplace_back(glm::vec3(c), 0.0F);
    }
    return centres;
}

void add_field(const PencilField& field, double unit, PencilSet& set) {
    std::vector<float4> radiance = set.radiance.read();
    for_texels(field, unit, [&](std::size_t at, std::size_t, const glm::vec3& light) { radiance[at] += float4(light, 0.0F); });
    set.radiance.write(radiance);
}

void set_field(const PencilField& field, double unit, bool weights, PencilSet& set) {
    std::vector<float4> radiance = weights ? set.radiance.read() : std::vector<float4>(set.radiance.size());
    for_texels(field, unit, [&](std::size_t at, std::size_t inside, const glm::vec3& light) {
        radiance[at] = float4(light, weights ? radiance[inside].w : 0.0F);
    });
    set.radiance.write(radiance);
}

FieldSum::FieldSum(const PencilSet& set, const FlatScene& flat, double free_share) : unit_(flat.normalisation.light) {
    field_.map = set.maps->n;
    field_.free_share = free_share;
    for (const float4& c : set.maps->cops.read()) field_.centres.push_back(flat.normalisation.to_world(glm::dvec3(c)));
    sum_.assign(3 * static_cast<std::size_t>(field_.width()) * static_cast<std::size_t>(field_.height()), 0.0);
}

void FieldSum::add(const PencilSet& set, const glm::dvec3& factor) {
    const int n = field_.map;
    const std::vector<float4> radiance = set.radiance.read();
    for (int tile = 0; tile < field_.count(); ++tile)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const float4& travels = radiance[atlas_index(tile, antipode({x, y}, n), n)];
                for (int c = 0; c < 3; ++c)
                    sum_[field_.index(tile, x, y) + static_cast<std::size_t>(c)] += factor[c] * static_cast<double>(travels[c]) * unit_;
            }
}

PencilField FieldSum::field() const {
    const double most = std::numeric_limits<float>::max();
    PencilField out = field_;
    out.light.reserve(sum_.size());
    std::transform(sum_.begin(), sum_.end(), std::back_inserter(out.light),
                   [most](double value) { return static_cast<float>(std::clamp(value, 0.0, most)); });
    return out;
}

}  // namespace pencil
