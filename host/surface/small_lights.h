// Lights that may stand so close to a surface that hardly any ray finds what they light there: point lights and small lamps. Each looks about
// from some of its places.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "film/render_context.h"
#include "surface/surface_pencils.h"

namespace pencil {

struct SmallLight {
    std::vector<glm::vec3> places;   // of its probes [scene units],
    std::vector<glm::vec3> normals;  // unit; each sees the half of all directions before it
    std::vector<int> planes;         // that they lie on, -1: none
    float extent = 0;                // [scene units], 0 of a point
    double strength = 0;             // power, rgb together [W], about
};

/// Those that matter most, few enough that looking about costs next to nothing: point lights, spots and profiles among `samples`, and lamps of
/// form `samples`.
std::vector<SmallLight> small_lights(const RenderContext& context, const std::vector<LightSample>& samples);

/// Width of the maps that probes look about with.
constexpr int probe_map = 16;

/// The probes of all lights, one after the other.
SurfacePencils probes_of(const std::shared_ptr<Device>& device, const std::vector<SmallLight>& lights);

}  // namespace pencil
