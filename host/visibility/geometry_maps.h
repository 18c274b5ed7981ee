// Geometry maps by the path that the cost model finds fastest (visibility_path.h).
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"

namespace pencil {

/// Makes the geometry maps of tiles `first` .. `first + count` by one of the paths that the scene is prepared for, and folds them.
void make_geometry_maps(Kernels& kernels, const DeviceScene& scene, GeometryMaps& maps, int first, int count);

}  // namespace pencil
