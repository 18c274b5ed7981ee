// Launcher of kernels/expand_maps.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"

namespace pencil {

enum class MapPart { light, weights };

/// Brings light or weights of a set to another with the same centres and finer maps, surface by surface; gutters, too. The other part stays.
void expand_maps(Kernels& kernels, const DeviceScene& scene, const PencilSet& coarse, MapPart part, PencilSet& set);

}  // namespace pencil
