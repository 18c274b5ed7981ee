#include "scene/gltf/read_light.h"

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "scene/gltf/turned_frame.h"
#include "scene/text.h"

namespace pencil {
namespace {

constexpr double lumen_per_watt = 683;

class LightReader {
public:
    LightReader(GltfFile& file, const tinygltf::Light& light, std::string label) : file_(file), light_(light), label_(std::move(label)) {}

    void read(const glm::dmat4& to_world, Scene& scene) {
        const std::optional<glm::dmat4> frame = turned_frame(to_world);
        if (!frame) file_.fail(label_ + " stands at a node without directions: its scale is zero");
        const glm::dvec3 position((*frame)[3]);
        ++scene.photometric_lights;
        if (!is_in_range(position)) file_.fail(label_ + " lies further than 1e18 from the origin");
        const glm::vec3 strength = colour() * static_cast<float>(intensity() / lumen_per_watt);
        if (light_.range > 0) file_.approximate("the range of lights is left out: they reach infinitely far");
        if (light_.type == "directional") {
            scene.directional_lights.push_back({glm::dvec3((*frame)[2]), strength});
        } else if (light_.type == "point" || light_.type == "spot") {
            PointLight point;
            point.position = position;
            point.intensity = strength;
            if (light_.type == "spot") read_cone(glm::dmat3(*frame), point);
            scene.point_lights.push_back(point);
        } else {
            file_.fail(label_ + " is of unknown type " + in_quotes(light_.type));
        }
    }

private:
    double intensity() const {
        const double value = light_.intensity;
        if (!(value >= 0 && value < 1e30)) file_.fail(label_ + ": the intensity must be a number from 0 on");
        return value;
    }

    glm::vec3 colour() const {
        if (light_.color.empty()) return glm::vec3(1.0F);
        if (light_.color.size() != 3) file_.fail(label_ + ": the colour has " + std::to_string(light_.color.size()) + " numbers, not 3");
        glm::vec3 result;
        for (int i = 0; i < 3; ++i) {
            const double value = light_.color[static_cast<std::size_t>(i)];
            if (!(value >= 0 && value < 1e6)) file_.fail(label_ + ": colours are numbers from 0 on");
            result[i] = static_cast<float>(value);
        }
        return result;
    }

    /// glTF lets the light fall by the square of a straight line in the cosine, a PointLight by a straight line in the angle.
    void read_cone(const glm::dmat3& frame, PointLight& point) const {
        const double inner = light_.spot.innerConeAngle, outer = light_.spot.outerConeAngle;
        constexpr double right_angle = 1.5707963267948966, rounding = 1e-6;
        if (!(inner >= 0 && inner <= outer && outer > 0 && outer <= right_angle + rounding))
            file_.fail(label_ + ": the angles of a spot must be 0 <= inner <= outer <= pi / 2");
        point.is_spot = true;
        point.to_world = frame;
        point.cutoff = glm::degrees(outer);
        point.beam_width = glm::degrees(std::min(inner, outer * (1 - rounding)));  // a step would divide by zero
    }

    GltfFile& file_;
    const tinygltf::Light& light_;
    std::string label_;
};

}  // namespace

void read_light(GltfFile& file, int index, const glm::dmat4& to_world, const std::string& user, Scene& scene) {
    const tinygltf::Light& light = file.at(file.model().lights, index, "light", user);
    LightReader(file, light, named("light", static_cast<std::size_t>(index), light.name)).read(to_world, scene);
}

}  // namespace pencil
