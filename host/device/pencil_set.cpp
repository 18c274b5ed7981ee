#include "device/pencil_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/vec3.hpp>

#include "util/error.h"

namespace pencil {

namespace {

/// Kernels index texels with 32 bits.
constexpr std::size_t most_texels = 0x7fffffff;

/// Width 0: no maps, and one texel since there are no empty buffers.
std::size_t atlas_texels(std::size_t tiles, const MapShape& shape) {
    if (shape.n == 0) return 1;
    const std::size_t texels = tiles * static_cast<std::size_t>(shape.stored());
    if (texels > most_texels)
        throw MemoryError(
            fmt::format("{} {} are more than one atlas holds (2^31 texels); use fewer pencils or light samples, or a smaller map", tiles,
                        describe(shape)));
    return texels;
}

std::vector<float4> positions_of(const std::vector<LightSample>& samples) {
    std::vector<float4> positions;
    positions.reserve(samples.size());
    for (const LightSample& s : samples) positions.emplace_back(glm::vec3(s.position), 0.0F);
    return positions;
}

}  // namespace

GeometryMaps::GeometryMaps(const std::shared_ptr<Device>& device, const std::vector<float4>& positions, const MapShape& map_shape,
                           const std::string& what)
    : count(static_cast<int>(positions.size())),
      n(map_shape.n),
      shape(map_shape),
      cops(device, positions, what + " centres"),
      hits(device, atlas_texels(positions.size(), map_shape), what + " geometry maps"),
      groups(device, atlas_texels(positions.size(), map_shape), what + " footprint groups"),
      cells(device, atlas_texels(positions.size(), map_shape), what + " footprint cells") {}

void GeometryMaps::copy_tile(const GeometryMaps& other, int source, int target) {
    const std::size_t texels = atlas_texels(1, shape), from = static_cast<std::size_t>(source), to = static_cast<std::size_t>(target);
    cops.copy_from(other.cops, from, to, 1);
    hits.copy_from(other.hits, from * texels, to * texels, texels);
    groups.copy_from(other.groups, from * texels, to * texels, texels);
    cells.copy_from(other.cells, from * texels, to * texels, texels);
}

PencilSet::PencilSet(const std::shared_ptr<Device>& device, std::shared_ptr<GeometryMaps> geometry)
    : maps(std::move(geometry)),
      radiance(device, atlas_texels(static_cast<std::size_t>(maps->count), maps->shape), "pencil radiance maps") {}

LightSet::LightSet(const std::shared_ptr<Device>& device, const std::vector<LightSample>& light_samples, const MapShape& shape)
    : samples(device, light_samples, "light samples"), maps(device, positions_of(light_samples), shape, "light sample") {
    const auto is_alone = [](const LightSample& s) {
        return s.position.w != LIGHT_AREA && !(s.position.w == LIGHT_INFINITE && s.normal.w > 0);
    };
    const auto first_of_many = std::find_if_not(light_samples.begin(), light_samples.end(), is_alone);
    alone = static_cast<int>(first_of_many - light_samples.begin());
}

}  // namespace pencil
