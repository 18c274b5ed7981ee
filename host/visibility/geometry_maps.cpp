#include "visibility/geometry_maps.h"

#include "visibility/rasterize_clusters.h"
#include "visibility/rasterize_octahedral.h"
#include "visibility/trace_maps.h"
#include "visibility/visibility_path.h"

namespace pencil {

void make_geometry_maps(Kernels& kernels, const DeviceScene& scene, GeometryMaps& maps, int first, int count) {
    switch (choose_path(scene.triangle_count, {count, maps.shape.width}, MapSpeed(*kernels.device()), scene.prepared(), maps.shape.kind)) {
        case VisibilityPath::rasterize:
            return rasterize_octahedral(kernels, scene, maps, first, count);
        case VisibilityPath::clusters:
            return rasterize_clusters(kernels, scene, maps, first, count);
        case VisibilityPath::trace:
            return trace_maps(kernels, scene, maps, first, count);
    }
}

}  // namespace pencil
