// Launcher of kernels/trace_film.cl.
#pragma once

#include <glm/vec2.hpp>

#include "device/device_scene.h"
#include "device/features.h"

namespace pencil {

/// As rasterize_film, through the scene's hierarchy: the same hits, ties of rounding apart.
void trace_film(Kernels& kernels, const DeviceScene& scene, const Camera& camera, const Buffer<glm::vec2>& offsets, int samples,
                int first_row, int rows, Buffer<Hit>& hits, const std::string& what = "trace film");

/// True if that is faster than to rasterise: every band of rows looks at every triangle, rays at few of them, and cost as much as
/// some hundred of those looks.
bool film_is_traced(const DeviceScene& scene, const Camera& camera);

}  // namespace pencil
