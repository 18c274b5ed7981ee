#include "line/find_enclosing.h"

namespace pencil {

std::vector<int> find_enclosing(Kernels& kernels, const DeviceScene& scene, const GeometryMaps& maps) {
    Buffer<int> enclosing(kernels.device(), static_cast<std::size_t>(maps.count), "enclosing shapes");
    kernels.get("find_enclosing")
        .args(maps.hits, maps.centres(), maps.n, scene.faces(), enclosing)
        .run(static_cast<std::size_t>(maps.count), "find enclosing shapes");
    return enclosing.read();
}

}  // namespace pencil
