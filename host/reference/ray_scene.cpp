// Embree as packaged aborts the program on rays that are not finite and quietly misses what is far from unit size, so the scene is
// normalised and each ray is checked first.
#include "reference/ray_scene.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "scene/light_unit.h"
#include "scene/split_triangle.h"
#include "scene/texture_lookup.h"
#include "util/error.h"

namespace pencil {
namespace {

/// A point v0 + u e1 + v e2 is off by a few rounding errors of its triangle's largest coordinate, and so is the distance at which Embree
/// finds the triangle again; 32 of them are safe and still below the offsets of Waechter and Binder (Ray Tracing Gems, 2019, ch. 6).
constexpr float offset_in_ulps = 32.0F * std::numeric_limits<float>::epsilon();

float largest_coordinate(const glm::vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// False for infinities and NaN, too.
bool castable(const Ray& ray) {
    constexpr float bound = 1e15F;  // far outside any scene, far inside what Embree accepts
    const glm::vec3 &o = ray.origin, &d = ray.direction;
    const float size = std::abs(o.x) + std::abs(o.y) + std::abs(o.z) + std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
    return size < bound && ray.length >= 0.0F;
}

RTCRay embree_ray(const Ray& ray) {
    RTCRay r;
    r.org_x = ray.origin.x;
    r.org_y = ray.origin.y;
    r.org_z = ray.origin.z;
    r.tnear = 0.0F;
    r.dir_x = ray.direction.x;
    r.dir_y = ray.direction.y;
    r.dir_z = ray.direction.z;
    r.time = 0.0F;
    r.tfar = ray.length;
    r.mask = ~0U;
    r.id = 0;
    r.flags = 0;
    return r;
}

[[noreturn]] void fail(RTCError code) {
    throw MemoryError("Embree cannot build its BVH (error " + std::to_string(static_cast<int>(code)) +
                      "); try a scene with fewer triangles or free some memory");
}

}  // namespace

RayScene::RayScene(const Scene& scene) : light_(light_unit(scene)), surfaces_(scene) {
    for (const Shape& shape : scene.shapes)
        emission_.push_back({shape.emits ? in_light_unit(shape.radiance, light_) : glm::vec3(0.0F), 0.0F, shape.radiance_texture});
    normalise(scene);
    build(add_triangles(scene));
    vertices_ = {};
}

void RayScene::normalise(const Scene& scene) {
    glm::dvec3 low(HUGE_VAL), high(-HUGE_VAL);
    const auto grow = [&](const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    };
    for (const Triangle3& t : scene.triangles)
        for (int k = 0; k < 3; ++k) grow(scene.positions[t.corners[k]]);
    for (const PointLight& light : scene.point_lights) grow(light.position);
    if (low.x > high.x) return;
    centre_ = glm::clamp(glm::dvec3(scene.sensor.to_world[3]), low, high);
    const double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    if (extent > 0) scale_ = std::exp2(std::ceil(std::log2(extent)) - 1);
}

std::vector<glm::uvec3> RayScene::add_triangles(const Scene& scene) {
    std::vector<glm::uvec3> kept;
    const bool smooth = std::any_of(scene.normals.begin(), scene.normals.end(), [](const glm::vec3& n) { return n != glm::vec3(0); });
    const bool textured = !surfaces_.plain();
    low_ = glm::dvec3(HUGE_VAL);
    high_ = glm::dvec3(-HUGE_VAL);
    kept.reserve(scene.triangles.size());
    triangles_.reserve(scene.triangles.size());
    for (const glm::dvec3& p : scene.positions) vertices_.push_back(glm::vec3(to_scene(p)));
    const TriangleSplitter splitter(glm::dvec3(scene.sensor.to_world[3]), scene.sensor.near_clip);
    const auto add = [&](const Triangle3& t, const glm::uvec3& indices, const TrianglePiece& piece) {
        const glm::vec3 corners[3] = {vertices_[indices.x], vertices_[indices.y], vertices_[indices.z]};
        const glm::dvec3 edge1 = glm::dvec3(corners[1]) - glm::dvec3(corners[0]), edge2 = glm::dvec3(corners[2]) - glm::dvec3(corners[0]);
        const glm::dvec3 normal = glm::cross(edge1, edge2);
        if (!(glm::length(normal) > 0)) return;
        float size = 0;
        for (const glm::vec3& corner : corners) {
            size = std::max(size, largest_coordinate(corner));
            low_ = glm::min(low_, glm::dvec3(corner));
            high_ = glm::max(high_, glm::dvec3(corner));
        }
        kept.push_back(indices);
        triangles_.push_back({corners[0], edge1, edge2, glm::normalize(normal), offset_in_ulps * size, t.shape, t.material});
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3 w(piece.weight[k]);
            const auto at_corner = [&](const auto& values) {
                return w.x * values[t.corners.x] + w.y * values[t.corners.y] + w.z * values[t.corners.z];
            };
            if (smooth) normals_.push_back(at_corner(scene.normals));
            if (textured && !scene.uvs.empty()) uvs_.push_back(at_corner(scene.uvs));
            if (textured && !scene.colours.empty()) colours_.push_back(at_corner(scene.colours));
        }
    };
    for (const Triangle3& t : scene.triangles) {
        const std::vector<TrianglePiece> pieces =
            splitter.split(scene.positions[t.corners.x], scene.positions[t.corners.y], scene.positions[t.corners.z]);
        if (pieces.size() == 1) {
            add(t, t.corners, pieces[0]);
            continue;
        }
        for (const TrianglePiece& piece : pieces) {
            const auto first = static_cast<std::uint32_t>(vertices_.size());
            for (const glm::dvec3& p : piece.corner) vertices_.push_back(glm::vec3(to_scene(p)));
            add(t, {first, first + 1, first + 2}, piece);
        }
    }
    if (triangles_.empty()) low_ = high_ = glm::dvec3(0.0);
    return kept;
}

void RayScene::build(const std::vector<glm::uvec3>& corners) {
    device_.reset(rtcNewDevice(nullptr));
    if (!device_) fail(rtcGetDeviceError(nullptr));
    bvh_.reset(rtcNewScene(device_.get()));
    if (!bvh_) fail(rtcGetDeviceError(device_.get()));
    rtcSetSceneFlags(bvh_.get(),
                     RTC_SCENE_FLAG_ROBUST);  // without it light leaks where edges meet (KnownAnswers.NoLight...), at 10 % less time
    if (!corners.empty()) {
        const std::unique_ptr<std::remove_pointer_t<RTCGeometry>, Release> geometry(
            rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
        auto* vertex = static_cast<glm::vec3*>(
            rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), vertices_.size()));
        auto* index = static_cast<glm::uvec3*>(
            rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), corners.size()));
        if (vertex == nullptr || index == nullptr) fail(rtcGetDeviceError(device_.get()));
        std::copy(vertices_.begin(), vertices_.end(), vertex);
        std::copy(corners.begin(), corners.end(), index);
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometry(bvh_.get(), geometry.get());
    }
    rtcCommitScene(bvh_.get());
    const RTCError error = rtcGetDeviceError(device_.get());
    if (error != RTC_ERROR_NONE) fail(error);
}

bool RayScene::intersect(const Ray& ray, RayHit& hit) const {
    if (!castable(ray)) return false;
    RTCRayHit query;
    query.ray = embree_ray(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(bvh_.get(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    const RayTriangle& t = triangles_[query.hit.primID];
    const float u = query.hit.u, v = query.hit.v;
    hit.point = t.corner + u * t.edge1 + v * t.edge2;
    hit.front = glm::dot(t.normal, ray.direction) < 0.0F;
    hit.normal = hit.front ? t.normal : -t.normal;
    hit.shading = normals_.empty() ? hit.normal : shading_normal(query.hit.primID, u, v, hit);
    hit.distance = query.ray.tfar;
    hit.offset = t.offset;
    hit.shape = t.shape;
    hit.material = t.material;
    hit.triangle = query.hit.primID;
    hit.u = u;
    hit.v = v;
    return true;
}

bool RayScene::occluded(const Ray& ray) const {
    if (!castable(ray)) return false;
    RTCRay query = embree_ray(ray);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(bvh_.get(), &context, &query);
    return query.tfar < 0.0F;
}

TexturePoint RayScene::texture_point(std::uint32_t triangle, float u, float v) const {
    TexturePoint point;
    const std::size_t first = std::size_t{3} * triangle;
    const float w = 1.0F - u - v;
    if (!colours_.empty()) point.colour = w * colours_[first] + u * colours_[first + 1] + v * colours_[first + 2];
    if (uvs_.empty()) return point;
    point.uv = w * uvs_[first] + u * uvs_[first + 1] + v * uvs_[first + 2];
    // The point is linear in the barycentric coordinates, and so is (u, v); a degenerate map has no slope.
    const RayTriangle& t = triangles_[triangle];
    const glm::vec2 a = uvs_[first + 1] - uvs_[first], b = uvs_[first + 2] - uvs_[first];
    const float determinant = a.x * b.y - a.y * b.x;
    if (determinant == 0.0F) return point;
    point.dp_du = (b.y * t.edge1 - a.y * t.edge2) / determinant;
    point.dp_dv = (a.x * t.edge2 - b.x * t.edge1) / determinant;
    return point;
}

glm::vec3 RayScene::emitted(std::uint32_t triangle, float u, float v) const {
    const SurfaceEmission& emission = emission_[triangles_[triangle].shape];
    if (emission.texture == no_texture) return emission.radiance;
    const TexturePoint point = texture_point(triangle, u, v);
    return emission.radiance * glm::vec3(look_up(surfaces_.texture(emission.texture), point.uv, point.colour));
}

glm::vec3 RayScene::shading_normal(std::uint32_t triangle, float u, float v, const RayHit& hit) const {
    const glm::vec3* corner = normals_.data() + std::size_t{3} * triangle;
    const glm::vec3 n = (1.0F - u - v) * corner[0] + u * corner[1] + v * corner[2];
    if (!(glm::dot(n, n) > 0.0F)) return hit.normal;
    return glm::normalize(hit.front ? n : -n);
}

}  // namespace pencil
