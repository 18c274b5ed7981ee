// A scene as its file describes it: world coordinates in double precision, one triangle list, Mitsuba's semantics.
#pragma once

#include <cstdint>
#include <glm/ext/vector_uint4_sized.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "shared/material.h"

namespace pencil {

/// Where colours of a surface come from, by its texture coordinates (u, v). Row 0 of a bitmap is its top row and lies at v from 0 on.
struct Texture {
    enum class Kind { bitmap, checkerboard, vertex_colours };
    enum class Wrap { repeat, mirror, clamp };
    Kind kind = Kind::bitmap;
    std::string name;       // of the file or element, for messages
    glm::dmat3 to_uv{1.0};  // applied to (u, v, 1) first
    // bitmap
    int width = 0, height = 0;
    std::vector<glm::u16vec4> texels;  // linear sRGB and opacity as half floats, width x height
    bool nearest = false;              // no bilinear filter
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
    // checkerboard: the first colour where floor(2 u) + floor(2 v) is even (Mitsuba's squares)
    glm::vec3 colours[2] = {glm::vec3(0.4F), glm::vec3(0.2F)};
};

constexpr int no_texture = -1;

/// Disney's principled BSDF as of Mitsuba 3; base colour and roughness are SceneMaterial's albedo and alpha (roughness itself, not its square).
struct PrincipledParameters {
    float metallic = 0, anisotropic = 0, spec_trans = 0, spec_tint = 0, sheen = 0, sheen_tint = 0, flatness = 0;
    float clearcoat = 0, clearcoat_gloss = 0;
    int metallic_texture = no_texture;  // its red channel times `metallic`
};

/// Scattering of one side of a surface, or, by dielectrics, of both. Names and meanings of parameters are Mitsuba's; colours are linear sRGB.
/// A colour with a texture is their product.
struct SceneMaterial {
    std::string id;                // from the file, or empty
    int model = MATERIAL_DIFFUSE;  // shared/material.h
    glm::vec3 albedo{0.5F};        // diffuse reflectance, base colour of principled; each in [0, 1]
    bool two_sided = false;        // the back scatters as the front does
    glm::vec3 parameters{0.0F};    // of a model that is not in this list
    int albedo_texture = no_texture;
    std::int64_t back = -1;  // index into Scene::materials of a back that differs from the front; then two_sided is true, too

    glm::vec3 specular{1.0F};     // specular_reflectance: factor of what is reflected by the boundary
    glm::vec3 transmitted{1.0F};  // specular_transmittance
    int specular_texture = no_texture, transmitted_texture = no_texture;
    glm::vec3 eta{1.5F};          // index of refraction inside over outside; with k that of a conductor, per channel
    glm::vec3 k{0.0F};            // extinction of a conductor
    bool perfect_mirror = false;  // conductor of material "none": reflects everything
    glm::vec2 alpha{0.0F};        // roughness of the microfacet distribution along u and v; 0: smooth. roughdiffuse: of its facets [radian]
    int alpha_texture = no_texture;  // its red channel times alpha
    bool beckmann = false;           // distribution of microfacets: Beckmann, or else GGX
    bool nonlinear = false;          // plastic: colour shifts by internal scattering
    bool thin = false;               // dielectric: two parallel boundaries, light goes on unturned (thindielectric)
    float exponent = 30.0F;          // phong
    PrincipledParameters principled{};

    // MATERIAL_BLEND: with probability weight the second, else the first. A mask is a blend of MATERIAL_PASS and what is masked.
    std::int64_t blended[2] = {-1, -1};  // indices into Scene::materials, lower than this one's
    float weight = 0.5F;
    int weight_texture = no_texture;  // its red channel times weight
    bool weight_is_opacity = false;   // the texture's opacity channel instead

    // Relief of the shading normal.
    int normal_texture = no_texture;
    bool bump = false;         // heights, else normals in tangent space, (n + 1) / 2 in rgb, x along u
    bool y_against_v = false;  // y of normals: up in pictures (glTF, MTL); else a left turn from u, also where those are mirrored (Mitsuba)
    float bump_scale = 1.0F;
};

struct Triangle3 {
    glm::uvec3 corners;          // indices into Scene::positions, normals and uvs
    std::uint32_t shape = 0;     // index into Scene::shapes
    std::uint32_t material = 0;  // index into Scene::materials
};

/// A name for triangles that belong together, and what they emit.
struct Shape {
    std::string id;    // from the file, or "rectangle 3": kind and ordinal
    std::string kind;  // rectangle, cube, sphere, obj, ply
    std::uint32_t first_triangle = 0;
    std::uint32_t triangle_count = 0;
    bool emits = false;
    glm::vec3 radiance{0.0F};           // of the front side [W m^-2 sr^-1]
    int radiance_texture = no_texture;  // times radiance
};

/// Luminous intensity by direction, as a table of vertical angles (0 .. 180 degrees from the axis) for each horizontal angle (0 .. 360): 1 on the
/// axis of a uniform light.
struct LightProfile {
    std::vector<float> vertical, horizontal;  // [degrees], ascending
    std::vector<float> values;                // vertical.size() for each horizontal angle
};

/// A point that emits: evenly, in a cone, or by a profile.
struct PointLight {
    glm::dvec3 position;
    glm::vec3 intensity;  // on the axis [W sr^-1]
    bool is_spot = false;
    glm::dmat3 to_world{1.0};             // of a spot or profile: its axis is +z
    double cutoff = 20, beam_width = 15;  // of a spot: falls linearly in the angle from one to the other [degrees] (Mitsuba)
    int profile = -1;                     // index into Scene::profiles
};

/// Parallel light from infinitely far away.
struct DirectionalLight {
    glm::dvec3 direction;  // in which it travels, unit
    glm::vec3 irradiance;  // of a surface across it [W m^-2]
};

/// Light from all around, infinitely far away: constant, or by a map of latitude and longitude as Mitsuba's envmap: direction d in its own frame
/// (+y up) lies at u = atan2(d.x, -d.z) / (2 pi), v = acos(d.y) / pi, row 0 at the top; the
/// first and last rows are centred on the poles.
struct Environment {
    glm::vec3 radiance{1.0F};  // [W m^-2 sr^-1]; with a map its factor
    int width = 0, height = 0;
    std::vector<glm::vec3> texels;
    glm::dmat3 to_world{1.0};
    bool is_map() const { return width > 0; }
};

struct ReconstructionFilter {
    enum class Kind { box, tent, gaussian, mitchell, catmullrom, lanczos };
    Kind kind = Kind::gaussian;           // Mitsuba's default
    double radius = 2.0;                  // half width of the support [pixels]
    double stddev = 0.5;                  // gaussian
    double b = 1.0 / 3.0, c = 1.0 / 3.0;  // mitchell
};

/// Looks along +z of its own frame, +y up, +x to the left of the image (Mitsuba).
struct PerspectiveSensor {
    bool orthographic = false;   // sees [-1, 1] of its own x across the width of the film; fov_x has no meaning
    double aperture_radius = 0;  // of a thin lens [world units], 0: a pinhole
    double focus_distance = 0;   // of a thin lens: depth of what is sharp
    glm::dmat4 to_world{1.0};
    double fov_x = 45.0;  // horizontal field of view [degrees], after fov_axis has been resolved
    double near_clip = 0.01, far_clip = 10000.0;
    int width = 768, height = 576;
    glm::dvec2 principal_point_offset{0.0};
    ReconstructionFilter filter;
    // The part of the film that is rendered [pixels]; 0 x 0: all of it. `width` and `height` are those of the whole film.
    int crop_x = 0, crop_y = 0, crop_width = 0, crop_height = 0;
};

/// Where irradiance is measured, at a point or as the mean over a shape. What lies there is lit, but shows nothing and hides nothing.
struct SensorPoint {
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0, 0.0, 1.0};  // unit
    std::int64_t shape = -1;           // >= 0: instead of these the front of a shape, all of it alike
};

/// Mitsuba's irradiancemeter: the mean irradiance of a shape's front.
struct IrradianceMeter {
    std::string id;
    std::uint32_t shape = 0;  // index into Scene::shapes
};

struct Scene {
    std::string file;
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> normals;  // unit shading normals, one per position; zero: use the face normal
    std::vector<glm::vec2> uvs;  // texture coordinates as Mitsuba's, one per position, zero where a shape has none; empty if all have none
    std::vector<Triangle3> triangles;
    std::vector<Shape> shapes;
    std::vector<SceneMaterial> materials;
    std::vector<Texture> textures;
    std::vector<glm::vec3> colours;  // of vertices, linear, one per position; empty if no shape has any
    std::vector<PointLight> point_lights;
    std::vector<LightProfile> profiles;
    std::vector<DirectionalLight> directional_lights;
    std::optional<Environment> environment;
    PerspectiveSensor sensor;
    std::vector<SensorPoint> sensor_points;  // the film, a pixel each in a row, instead of what `sensor` sees
    std::vector<IrradianceMeter> meters;
    int photometric_lights = 0;  // lights that were given in lumens, candela or lux: 683 of them are a watt
    int max_depth = -1;          // 1: emission only, 2: plus direct light, -1: no limit
    std::vector<std::string> warnings;
};

}  // namespace pencil
