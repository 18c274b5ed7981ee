#include "scene/mitsuba/read_emitter.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "scene/mitsuba/sun_and_sky.h"
#include "scene/read_ies.h"
#include "scene/scene_file.h"
#include "scene/text.h"
#include "scene/textures/read_environment.h"

namespace pencil {
namespace {

/// Axes of a transform without their lengths: for lights, whose frame only turns.
glm::dmat3 rotation_of(Properties& p, const glm::dmat4& to_world) {
    constexpr double tolerance = 1e-3;
    glm::dmat3 frame(to_world);
    bool skewed = false;
    for (int i = 0; i < 3; ++i) frame[i] = glm::normalize(frame[i]);
    for (int i = 0; i < 3; ++i) skewed = skewed || std::abs(glm::dot(frame[i], frame[(i + 1) % 3])) > tolerance;
    if (skewed) p.approximate("to_world", "a to_world that shears is not supported here: its axes are used");
    return frame;
}

}  // namespace

void EmitterReader::finish(Properties& p) {
    p.ignore({"sampling_weight", "medium", "to_world", "bbox_center", "bbox_radius"});
    p.finish();
}

void EmitterReader::read(pugi::xml_node node) {
    Properties p(source_, node);
    const std::string type = node.attribute("type").value();
    if (type == "area" && node.attribute("id")) return;  // for shapes that refer to it
    if (type == "area") source_.fail(node, p.label() + " must stand inside the shape that emits");
    if (type == "point")
        point(p);
    else if (type == "spot")
        spot(p);
    else if (type == "directional")
        directional(p);
    else if (type == "constant")
        constant(p);
    else if (type == "envmap")
        envmap(p);
    else if (type == "sun" || type == "sky" || type == "sunsky")
        sun_and_sky(p, type);
    else if (type == "ies")
        photometric(p);
    else
        return p.approximate("", "is not supported: left out");
    finish(p);
}

void EmitterReader::read_area(const NestedObject& object, Shape& shape) {
    Properties p(source_, object.node);
    shape.emits = true;
    if (object.type != "area") p.approximate("", "inside a shape is not supported: read as area");
    const ColourSlot slot = textures_.colour(p, "radiance", glm::vec3(1.0F), ColourUse::emission);
    shape.radiance = slot.value;
    shape.radiance_texture = slot.texture;
    finish(p);
}

void EmitterReader::point(Properties& p) {
    if (p.has("position") && p.has("to_world")) p.fail("position", "give either position or to_world, not both");
    PointLight light;
    light.position = p.vector("position", glm::dvec3(p.transform("to_world")[3]));
    light.intensity = p.colour("intensity", glm::vec3(1.0F), ColourUse::emission);
    scene_.point_lights.push_back(light);
}

void EmitterReader::spot(Properties& p) {
    const glm::dmat4 to_world = p.transform("to_world");
    PointLight light;
    light.is_spot = true;
    light.position = glm::dvec3(to_world[3]);
    light.to_world = rotation_of(p, to_world);
    light.intensity = p.colour("intensity", glm::vec3(1.0F), ColourUse::emission);
    light.cutoff = p.number("cutoff_angle", 20);
    light.beam_width = p.number("beam_width", light.cutoff * 0.75);
    if (!(light.cutoff > 0 && light.cutoff <= 180)) p.fail("cutoff_angle", "cutoff_angle must lie in (0, 180] degrees");
    if (!(light.beam_width >= 0)) p.fail("beam_width", "beam_width must not be negative");
    light.beam_width = std::min(light.beam_width, light.cutoff);
    if (p.take_texture("texture")) p.approximate("", "a texture on a spot light is not supported: left out");
    scene_.point_lights.push_back(light);
}

void EmitterReader::directional(Properties& p) {
    if (p.has("direction") && p.has("to_world")) p.fail("direction", "give either direction or to_world, not both");
    const glm::dvec3 direction = p.vector("direction", glm::dvec3(p.transform("to_world")[2]));
    if (!(glm::length(direction) > 0)) p.fail("direction", "direction must not be zero");
    scene_.directional_lights.push_back({glm::normalize(direction), p.colour("irradiance", glm::vec3(1.0F), ColourUse::emission)});
}

void EmitterReader::constant(Properties& p) {
    Environment environment;
    environment.radiance = p.colour("radiance", glm::vec3(1.0F), ColourUse::emission);
    set_environment(p, std::move(environment));
}

void EmitterReader::envmap(Properties& p) {
    if (!p.has("filename")) p.fail("", "needs a filename");
    Environment environment;
    TextureUse use;
    if (const double gamma = p.number("gamma", -1); gamma > 0) use.gamma = gamma;
    read_environment(source_.find_file(p.text("filename", ""), p.node()), use, source_.where(p.node()), environment);
    environment.radiance = glm::vec3(static_cast<float>(p.number("scale", 1)));
    environment.to_world = rotation_of(p, p.transform("to_world"));
    p.ignore({"cache", "mis_compensation"});
    set_environment(p, std::move(environment));
}

void EmitterReader::sun_and_sky(Properties& p, const std::string& type) {
    const SunAndSky sky = read_sun_and_sky(p, type, source_.version(p.node()));
    const glm::dmat3 to_world = rotation_of(p, p.transform("to_world"));
    if (sky.sun.irradiance != glm::vec3(0.0F))
        scene_.directional_lights.push_back({glm::normalize(to_world * sky.sun.direction), sky.sun.irradiance});
    if (!sky.sky) return;
    Environment environment = *sky.sky;
    environment.to_world = to_world * environment.to_world;
    set_environment(p, std::move(environment));
}

/// Not a plugin of Mitsuba's: a point light with the file of a lamp's maker.
void EmitterReader::photometric(Properties& p) {
    if (!p.has("filename")) p.fail("", "needs a filename");
    const std::filesystem::path file = source_.find_file(p.text("filename", ""), p.node());
    constexpr std::uintmax_t max_bytes = std::uintmax_t{4} << 20;
    const PhotometricData data = read_ies(read_regular_file(file, max_bytes, source_.where(p.node())), shown(file));
    const glm::dmat4 to_world = p.transform("to_world");
    PointLight light;
    light.position = glm::dvec3(to_world[3]);
    light.to_world = rotation_of(p, to_world);
    constexpr double lumens_per_watt = 683;
    scene_.photometric_lights += p.has("intensity") ? 0 : 1;
    light.intensity = p.colour("intensity", glm::vec3(static_cast<float>(data.candela / lumens_per_watt)), ColourUse::emission);
    light.profile = static_cast<int>(scene_.profiles.size());
    scene_.profiles.push_back(data.profile);
    scene_.point_lights.push_back(light);
}

void EmitterReader::set_environment(Properties& p, Environment environment) {
    if (scene_.environment) return p.approximate("", "is a second light from all around: left out");
    scene_.environment = std::move(environment);
}

}  // namespace pencil
