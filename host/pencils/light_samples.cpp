#include "pencils/light_samples.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>
#include <limits>
#include <numeric>

#include "image/colour.h"
#include "pencils/flat_sky.h"
#include "pencils/low_discrepancy.h"
#include "pencils/warps.h"
#include "scene/light_chances.h"
#include "scene/texture_lookup.h"
#include "util/constants.h"

namespace pencil {

namespace {

/// Barycentric coordinates of sample `k` of a triangle: threes of samples are one point and its two rotations among the corners. Their mean
/// is the centre, so linear functions over the triangle are integrated exactly, and the distribution stays uniform.
glm::dvec3 triangle_point(std::uint64_t k, const glm::dvec2& shift) {
    const glm::dvec2 u = square_to_triangle(r2_sequence(k / 3, shift));
    const glm::dvec3 b(1.0 - u.x - u.y, u.x, u.y);
    return k % 3 == 0 ? b : k % 3 == 1 ? glm::dvec3(b.z, b.x, b.y) : glm::dvec3(b.y, b.z, b.x);
}

/// `area`: what the sample stands for; `near`: the same on average over its emitter, which says how near is near (light_sample.cl).
LightSample area_sample(const Triangle& t, const float4& plane, const glm::dvec3& radiance, double area, double near, const glm::dvec3& b) {
    LightSample s{};
    s.position = float4(glm::vec3(b.x * glm::dvec3(t.v0) + b.y * glm::dvec3(t.v1) + b.z * glm::dvec3(t.v2)), 1.0F);
    s.normal = float4(glm::vec3(plane), static_cast<float>(near / pi));
    s.emission = float4(glm::vec3(radiance * area), static_cast<float>(t.plane));
    return s;
}

/// Emitted radiance of a point of a triangle, in the unit of the scene file.
glm::dvec3 radiance_at(const Scene& scene, const FlatScene& flat, const Triangle& t, const glm::dvec3& b) {
    const Shape& shape = scene.shapes[static_cast<std::size_t>(t.shape)];
    if (shape.radiance_texture == no_texture) return glm::dvec3(shape.radiance);
    const auto first = 3 * static_cast<std::size_t>(&t - flat.triangles.data());
    const auto mean = [&](const auto* corner) {
        return static_cast<float>(b.x) * corner[0] + static_cast<float>(b.y) * corner[1] + static_cast<float>(b.z) * corner[2];
    };
    const auto index = static_cast<std::size_t>(shape.radiance_texture);
    const TextureRow& row = flat.textures[index];
    if (row.kind == TEXTURE_VERTEX_COLOURS) {
        glm::vec4 colours[3];
        for (std::size_t k = 0; k < 3; ++k) colours[k] = glm::unpackHalf4x16(flat.texels[static_cast<std::size_t>(row.first) + first + k]);
        return glm::dvec3(shape.radiance) * glm::dvec3(mean(colours));
    }
    const glm::vec2 uv = flat.uvs.empty() ? glm::vec2(0) : mean(flat.uvs.data() + first);
    return glm::dvec3(shape.radiance) * glm::dvec3(look_up(scene.textures[index], uv, glm::vec3(1)));
}

struct ShapeTriangles {
    std::size_t shape = 0;
    double luminance = 0;  // of its mean radiance
    double area = 0;
    std::vector<const Triangle*> triangles;
    std::vector<double> up_to;  // weight of the triangles up to and with this one: without receivers their area

    double power() const { return pi * area * luminance; }
    double weight(std::size_t t) const { return up_to[t] - (t > 0 ? up_to[t - 1] : 0.0); }
};

/// Share of a shape's samples that goes by area: what none of the receivers sees may light others.
constexpr double share_by_area = 0.15;

/// Light per area that a triangle would send to the receivers, if nothing stood between.
double light_to(const Triangle& t, const glm::dvec3& normal, const std::vector<LightReceiver>& receivers) {
    const glm::dvec3 middle = (glm::dvec3(t.v0) + glm::dvec3(t.v1) + glm::dvec3(t.v2)) / 3.0;
    const double area = glm::length(area_vector(t));
    double sum = 0;
    for (const LightReceiver& r : receivers) {
        const glm::dvec3 step = glm::dvec3(r.position) - middle;
        const double out = glm::dot(step, normal), in = -glm::dot(step, glm::dvec3(r.normal)), square = glm::dot(step, step);
        if (out > 0 && in > 0) sum += out * in / (square * (square + area));
    }
    return std::min(sum, 1e30);  // finite as a float
}

/// Place along a curve that fills the cube about the shape and keeps neighbours together: bits of the three coordinates in turn (Morton 1966).
std::uint64_t curve_place(const Triangle& t, const glm::dvec3& low, double inverse_size) {
    const glm::dvec3 middle = (glm::dvec3(t.v0) + glm::dvec3(t.v1) + glm::dvec3(t.v2)) / 3.0;
    const glm::uvec3 cell(glm::clamp((middle - low) * inverse_size, 0.0, 1.0) * 1023.0);
    std::uint64_t place = 0;
    for (unsigned bit = 10; bit-- > 0;)
        for (int axis = 0; axis < 3; ++axis) place = place << 1U | (cell[axis] >> bit & 1U);
    return place;
}

/// Samples are drawn at equal steps of area along the list: in this order they are spread over the shape, and so are its normals.
void order_along_curve(std::vector<const Triangle*>& triangles) {
    glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
    for (const Triangle* t : triangles)
        for (const float4& v : {t->v0, t->v1, t->v2}) {
            low = glm::min(low, glm::dvec3(v));
            high = glm::max(high, glm::dvec3(v));
        }
    const glm::dvec3 extent = high - low;
    const double size = std::max({extent.x, extent.y, extent.z});
    std::vector<std::pair<std::uint64_t, const Triangle*>> placed;
    placed.reserve(triangles.size());
    for (const Triangle* t : triangles) placed.emplace_back(curve_place(*t, low, size > 0 ? 1.0 / size : 0.0), t);
    std::stable_sort(
        placed.begin(), placed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::transform(placed.begin(), placed.end(), triangles.begin(), [](const auto& p) { return p.second; });
}

/// Weights of the triangles, in the order of the list.
void weigh(ShapeTriangles& e, const FlatScene& flat, const std::vector<float>& importance) {
    std::vector<double> areas, weights;
    double total = 0;
    for (const Triangle* t : e.triangles) {
        areas.push_back(glm::length(area_vector(*t)));
        const auto number = static_cast<std::size_t>(t - flat.triangles.data());
        weights.push_back(importance.empty() ? 0.0 : areas.back() * static_cast<double>(importance[number]));
        e.area += areas.back();
        total += weights.back();
    }
    double sum = 0;
    for (std::size_t i = 0; i < areas.size(); ++i)
        e.up_to.push_back(sum += total > 0 ? share_by_area * areas[i] + (1 - share_by_area) * e.area * weights[i] / total : areas[i]);
}

std::vector<ShapeTriangles> emitting_shapes(const Scene& scene, const FlatScene& flat, const std::vector<LightForm>& forms,
                                            const std::vector<float>& importance) {
    std::vector<ShapeTriangles> emitters;
    for (const Triangle& t : flat.triangles) {
        const auto shape = static_cast<std::size_t>(t.shape);
        if (!scene.shapes[shape].emits || forms[shape] != LightForm::samples) continue;
        if (emitters.empty() || emitters.back().shape != shape)
            emitters.push_back({shape, luminance(glm::dvec3(flat.materials[static_cast<std::size_t>(t.material)].emission)), 0, {}, {}});
        emitters.back().triangles.push_back(&t);
    }
    emitters.erase(std::remove_if(emitters.begin(), emitters.end(), [](const ShapeTriangles& e) { return !(e.luminance > 0); }),
                   emitters.end());
    for (ShapeTriangles& e : emitters) {
        order_along_curve(e.triangles);
        weigh(e, flat, importance);
    }
    return emitters;
}

/// How one shape is sampled.
struct ShapeSamples {
    long count;
    std::uint64_t seed, turn;
};

/// Surfels that draw consider whole threes of the samples from `first` on (sample_lights.cl). Where these are not of one triangle but of three next
/// to each other, as on a round lamp, they would say thrice the same: the members of each come to lie a third of the shape apart.
void spread_threes(std::vector<LightSample>& samples, std::size_t first) {
    const std::size_t count = samples.size() - first, third = count / 3;
    const std::vector<LightSample> along(samples.begin() + static_cast<std::ptrdiff_t>(first), samples.end());
    for (std::size_t k = 0; k < 3 * third; ++k) samples[first + k] = along[k % 3 * third + k / 3];
}

/// Systematic in the weight, so that each triangle gets its share to within one sample; low-discrepancy within the triangles and from one set
/// to the next.
void sample_shape(const ShapeTriangles& e, const Scene& scene, const FlatScene& flat, const ShapeSamples& own,
                  std::vector<LightSample>& samples) {
    const double start = fraction(random_unit(own.seed, 2, 0) + static_cast<double>(own.turn) * golden_ratio);
    const double step = e.up_to.back() / static_cast<double>(own.count);
    // Threes stay together: a turn has room for all that a triangle may get, rounded up to them.
    const auto used = [&](std::size_t t) { return own.turn * 3 * static_cast<std::uint64_t>(std::ceil(e.weight(t) / step / 3.0)); };
    std::size_t triangle = 0;
    const std::size_t first = samples.size();
    std::uint64_t within = used(0);
    for (long k = 0; k < own.count; ++k, ++within) {
        const double passed = (static_cast<double>(k) + start) * step;
        while (triangle + 1 < e.up_to.size() && e.up_to[triangle] <= passed) within = used(++triangle);
        const Triangle& t = *e.triangles[triangle];
        const glm::dvec2 shift(random_unit(own.seed, 0, triangle), random_unit(own.seed, 1, triangle));
        const double area = step * glm::length(area_vector(t)) / e.weight(triangle), near = e.area / static_cast<double>(own.count);
        const glm::dvec3 at = triangle_point(within, shift);
        samples.push_back(area_sample(t, flat.planes[static_cast<std::size_t>(t.plane)],
                                      radiance_at(scene, flat, t, at) / flat.normalisation.light, area, near, at));
    }
    if (static_cast<std::size_t>(own.count) < 3 * e.triangles.size()) spread_threes(samples, first);
}

LightSample point_sample(const PointLight& light, int profile_table, const FlatScene& flat) {
    constexpr double degree = pi / 180;
    const double scale = flat.normalisation.scale;
    LightSample s{};
    s.position = float4(glm::vec3(flat.normalisation.to_scene(light.position)), LIGHT_POINT);
    s.emission = float4(flat.normalisation.to_light(glm::dvec3(light.intensity) / (scale * scale)), -1.0F);
    if (profile_table >= 0) {
        s.position.w = LIGHT_PROFILE;
        s.normal = float4(glm::vec3(glm::normalize(glm::dvec3(light.to_world[2]))), 0.0F);
        s.emission.w = static_cast<float>(profile_table);
        return s;
    }
    if (!light.is_spot) return s;
    s.position.w = LIGHT_SPOT;
    s.normal = float4(glm::vec3(glm::normalize(glm::dvec3(light.to_world[2]))), static_cast<float>(light.beam_width * degree));
    s.emission.w = static_cast<float>(light.cutoff * degree);
    return s;
}

int sky_samples(double share, int count) { return std::max(static_cast<int>(std::lround(share * count)), std::max(count / 4, 1)); }

/// Boxes of shapes, and of what does not emit; low > high where there is nothing.
struct ShapeBox {
    glm::dvec3 low{HUGE_VAL}, high{-HUGE_VAL};
    void grow(const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
};

double square_distance(const ShapeBox& a, const ShapeBox& b) {
    const glm::dvec3 gap = glm::max(glm::max(a.low - b.high, b.low - a.high), glm::dvec3(0));
    return glm::dot(gap, gap);
}

/// Square distance from the box of each emitting shape to that of all that does not emit.
std::vector<double> square_distances(const Scene& scene) {
    std::vector<ShapeBox> boxes(scene.shapes.size());
    ShapeBox rest;
    for (const Triangle3& t : scene.triangles)
        for (int k = 0; k < 3; ++k) (scene.shapes[t.shape].emits ? boxes[t.shape] : rest).grow(scene.positions[t.corners[k]]);
    std::vector<double> distances;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        distances.push_back(scene.shapes[i].emits && rest.low.x <= rest.high.x ? square_distance(boxes[i], rest) : 0);
    return distances;
}

}  // namespace

bool maps_carry_emitters(const Scene& scene, const std::vector<LightForm>& forms) {
    for (std::size_t i = 0; i < forms.size(); ++i)
        if (scene.shapes[i].emits && forms[i] == LightForm::maps) return true;
    return false;
}

std::vector<LightForm> choose_light_forms(const Scene& scene, bool all_samples, bool all_maps) {
    const std::vector<double> areas = shape_areas(scene), distances = square_distances(scene);
    double total = std::accumulate(areas.begin(), areas.end(), 0.0);
    std::vector<LightForm> forms(scene.shapes.size(), LightForm::samples);
    for (std::size_t i = 0; i < forms.size(); ++i) {
        const bool large = areas[i] > large_emitter * total && distances[i] <= far_emitter * areas[i];
        if (scene.shapes[i].emits && (all_maps || (large && !all_samples))) forms[i] = LightForm::maps;
    }
    return forms;
}

std::vector<float> light_importance(const Scene& scene, const FlatScene& flat, const std::vector<LightForm>& forms,
                                    const std::vector<LightReceiver>& receivers) {
    std::vector<float> importance(flat.triangles.size(), 0.0F);
    for (const ShapeTriangles& e : emitting_shapes(scene, flat, forms, {}))
        for (const Triangle* t : e.triangles)
            importance[static_cast<std::size_t>(t - flat.triangles.data())] =
                static_cast<float>(light_to(*t, glm::dvec3(flat.planes[static_cast<std::size_t>(t->plane)]), receivers));
    return importance;
}

std::vector<LightSample> sample_lights(const Scene& scene, const FlatScene& flat, const std::vector<LightForm>& forms, int count,
                                       std::uint64_t seed, std::uint64_t turn, const std::vector<float>& importance) {
    std::vector<LightSample> samples;
    for (std::size_t i = 0; i < scene.point_lights.size(); ++i)
        samples.push_back(point_sample(scene.point_lights[i], flat.profile_tables[i], flat));
    for (const DirectionalLight& light : scene.directional_lights) {
        LightSample s{};
        s.position = float4(glm::vec3(light.direction), LIGHT_INFINITE);
        s.emission = float4(flat.normalisation.to_light(light.irradiance), -1.0F);
        samples.push_back(s);
    }
    // The sky's share of the samples is as if it lit the whole scene from outside.
    const double sky = sampled_sky_power(flat.sky, flat.sky_texels) * cross_section(flat);
    // Each emitting shape gets samples by its chance, at least one, spread over its triangles by area.
    const std::vector<ShapeTriangles> emitters = emitting_shapes(scene, flat, forms, importance);
    LightChances chances;
    chances.add(sky);
    for (const ShapeTriangles& e : emitters) chances.add(e.power());
    for (const ShapeTriangles& e : emitters) {
        const long own = std::max(std::lround(chances.of(e.power()) * count), 1L);
        sample_shape(e, scene, flat, {own, hash64(seed) ^ e.shape, turn}, samples);
    }
    if (sky > 0) sample_sky(flat.sky, flat.sky_texels, sky_samples(chances.of(sky), count), seed, turn, samples);
    return samples;
}

bool has_detailed_emitters(const Scene& scene, const FlatScene& flat, const std::vector<LightForm>& forms) {
    constexpr std::size_t quad = 2;
    const std::vector<ShapeTriangles> emitters = emitting_shapes(scene, flat, forms, {});
    return std::any_of(emitters.begin(), emitters.end(), [](const ShapeTriangles& e) { return e.triangles.size() > quad; });
}

std::vector<float> near_areas(const FlatScene& flat, const std::vector<LightSample>& samples, double factor) {
    std::vector<std::size_t> shape_of_plane(flat.planes.size());
    for (const Triangle& t : flat.triangles) shape_of_plane[static_cast<std::size_t>(t.plane)] = static_cast<std::size_t>(t.shape);
    std::vector<float> of_shape(static_cast<std::size_t>(flat.shape_count), std::numeric_limits<float>::infinity());
    for (const LightSample& s : samples) {
        if (s.position.w != LIGHT_AREA) continue;  // the others have no surface
        // A float holds the index; beyond 2^24 planes it may be rounded, but not out of the list.
        const auto plane = std::min(static_cast<std::size_t>(s.emission.w), shape_of_plane.size() - 1);
        of_shape[shape_of_plane[plane]] = s.normal.w * static_cast<float>(factor);
    }
    std::vector<float> areas;
    for (const int shape : flat.row_shapes)
        areas.push_back(shape < 0 ? std::numeric_limits<float>::infinity() : of_shape[static_cast<std::size_t>(shape)]);
    return areas;
}

}  // namespace pencil
