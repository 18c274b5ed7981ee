// White receivers: surfels that reflect all light evenly, so that what they send is irradiance / pi.
#pragma once

#include <vector>

#include "device/features.h"
#include "device/surfels.h"
#include "device/turn.h"
#include "pencils/flat_scene.h"
#include "scene/scene.h"

namespace pencil {

struct Receivers {
    Surfels surfels;
    std::vector<glm::vec3> viewers;  // of each: a point of the side that light comes to [scene units]
    std::vector<int> counts;         // of each sensor, one after the other
};

/// Of a sensor that is a shape.
constexpr int points_of_shape = 64;

/// Of all sensors of a scene.
int count_receivers(const Scene& scene);

/// At the sensors of the scene, in their order; on shapes at other points each turn. They lie a little before these, for many lie on surfaces.
Receivers sensor_receivers(const Kernels& kernels, const Scene& scene, const FlatScene& flat, const Turn& turn);

/// Surfels of what a camera sees become white receivers. A meter that is laid on a relief does not follow its texture: there receivers face as
/// the triangles do. materials: rows of the scene.
void make_white(Surfels& surfels, const std::vector<Material>& materials);

}  // namespace pencil
