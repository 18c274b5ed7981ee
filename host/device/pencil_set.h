// A set of pencils in device memory: centres and atlases of their maps (kernels/shared/atlas.h). Also the geometry maps of light samples.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <tuple>
#include <vector>

#include "cl/buffer.h"
#include "device/device_scene.h"
#include "device/map_shape.h"
#include "shared/atlas.h"
#include "shared/geometry.h"
#include "shared/light.h"
#include "shared/types.h"

namespace pencil {

/// Geometry maps: what every texel of every tile sees.
struct GeometryMaps {
    GeometryMaps() = default;
    /// A shape of width 0: centres without maps, for rays.
    GeometryMaps(const std::shared_ptr<Device>& device, const std::vector<float4>& positions, const MapShape& map_shape,
                 const std::string& what);

    /// Copies one tile of maps of the same size.
    void copy_tile(const GeometryMaps& other, int source, int target);

    /// Arguments of kernels: `cops, pencil_count`; `cops, first_tile, tile_count, n`.
    auto centres() const { return std::tie(cops, count); }
    auto tiles(int first, int number) const { return std::tuple<const Buffer<float4>&, int, int, int>(cops, first, number, n); }

    /// Texels of a tile, without gutters and with.
    int texels() const { return shape.texels(); }
    int stored() const { return shape.stored(); }

    int count = 0;   // tiles
    int n = 0;       // texels along a side of a panel
    MapShape shape;  // of every tile
    Buffer<float4> cops;
    Buffer<Hit> hits;
    Buffer<glm::ivec4> groups;  // triangles about footprints that no plane fills
    Buffer<glm::ivec2> cells;   // planes that each footprint shows for sure, see fold_hits.cl
};

/// Arguments `cells, groups, hits, triangles, planes, n` of kernels that test visibility by maps.
inline auto visibility_map(const GeometryMaps& maps, const DeviceScene& scene) {
    return std::tie(maps.cells, maps.groups, maps.hits, scene.triangles, scene.planes, maps.n);
}

/// Pencils: geometry maps with radiance (rgb) and density weight 1/D (w) per texel. Sets of one fixed iteration share their maps.
struct PencilSet {
    PencilSet() = default;
    PencilSet(const std::shared_ptr<Device>& device, std::shared_ptr<GeometryMaps> geometry);

    std::shared_ptr<GeometryMaps> maps;
    Buffer<float4> radiance;
    std::shared_ptr<GeometryMaps> light_maps, weight_maps;  // through whose texels light and weights are found; null: through those of maps
};

/// Light samples with their geometry maps.
struct LightSet {
    LightSet() = default;
    LightSet(const std::shared_ptr<Device>& device, const std::vector<LightSample>& light_samples, const MapShape& shape);

    /// Arguments `samples, sample_count` of kernels.
    auto list() const { return std::tie(samples, maps.count); }

    Buffer<LightSample> samples;
    int alone = 0;  // samples at the beginning that are each a light of its own
    GeometryMaps maps;
};

}  // namespace pencil
