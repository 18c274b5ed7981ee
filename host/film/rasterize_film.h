// Launcher of kernels/bound_film.cl and kernels/rasterize_film.cl.
#pragma once

#include <glm/vec2.hpp>

#include "device/device_scene.h"
#include "device/features.h"

namespace pencil {

/// What the camera sees at `samples` offsets in every pixel of rows first_row .. first_row + rows: hits[(sample * rows + row) * width + x].
/// `what` is the profiling key.
void rasterize_film(Kernels& kernels, const DeviceScene& scene, const Camera& camera, const Buffer<glm::vec2>& offsets, int samples,
                    int first_row, int rows, Buffer<Hit>& hits, const std::string& what = "rasterize film");

}  // namespace pencil
