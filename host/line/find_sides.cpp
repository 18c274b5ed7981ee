#include "line/find_sides.h"

namespace pencil {

std::vector<uint> find_sides(Kernels& kernels, const DeviceScene& scene, const GeometryMaps& maps) {
    const std::size_t words = side_words(static_cast<std::size_t>(scene.shape_count)), tiles = static_cast<std::size_t>(maps.count);
    Buffer<uint> sides(kernels.device(), tiles * words, "sides of shapes seen");
    kernels.get("find_sides")
        .args(maps.hits, maps.centres(), maps.n, scene.faces(), scene.materials, sides, static_cast<int>(words))
        .run(tiles, "find sides of shapes");
    return sides.read();
}

}  // namespace pencil
