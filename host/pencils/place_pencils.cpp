#include "pencils/place_pencils.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "pencils/low_discrepancy.h"

namespace pencil {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kMaxTries = 64;

using Point = std::array<double, 3>;

/// Closed: welding equal positions, every directed edge has its reverse exactly once.
bool is_closed(const std::vector<glm::dvec3>& corners) {
    std::map<Point, int> ids;
    std::map<std::pair<int, int>, int> edges;
    for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
        int v[3];
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3& p = corners[t + static_cast<std::size_t>(k)];
            v[k] = ids.emplace(Point{p.x, p.y, p.z}, static_cast<int>(ids.size())).first->second;
        }
        for (int k = 0; k < 3; ++k) ++edges[{v[k], v[(k + 1) % 3]}];
    }
    return !edges.empty() && std::all_of(edges.begin(), edges.end(), [&](const auto& e) {
        auto reverse = edges.find({e.first.second, e.first.first});
        return e.second == 1 && reverse != edges.end() && reverse->second == 1;
    });
}

/// Signed solid angle of a triangle (van Oosterom and Strackee 1983), corners relative to the point.
double solid_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    double det = glm::dot(a, glm::cross(b, c));
    double div = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    return 2.0 * std::atan2(det, div);
}

}  // namespace

bool Solids::Solid::encloses(const glm::dvec3& p) const {
    if (glm::any(glm::lessThan(p, low)) || glm::any(glm::greaterThan(p, high))) return false;
    double sum = 0;
    for (std::size_t t = 0; t + 2 < corners.size(); t += 3) sum += solid_angle(corners[t] - p, corners[t + 1] - p, corners[t + 2] - p);
    return std::abs(sum) > 2.0 * kPi;  // winding number +-1 is 4 pi
}

Solids::Solids(const Scene& scene, const FlatScene& flat) {
    std::vector<glm::dvec3> witnesses = {glm::dvec3(flat.camera.origin)};
    for (const PointLight& light : scene.point_lights) witnesses.push_back(flat.normalisation.to_scene(light.position));
    std::map<int, Solid> shapes;
    for (const Triangle& t : flat.triangles) {
        Solid& solid = shapes[t.shape];
        for (const float4& v : {t.v0, t.v1, t.v2}) solid.corners.emplace_back(v);
        if (scene.shapes[static_cast<std::size_t>(t.shape)].emits && solid.corners.size() == 3) {
            // Just in front of an emitter (of its first triangle) is free space.
            glm::dvec3 middle = (glm::dvec3(t.v0) + glm::dvec3(t.v1) + glm::dvec3(t.v2)) / 3.0;
            witnesses.push_back(middle + 1e-5 * glm::dvec3(flat.planes[static_cast<std::size_t>(t.plane)]));
        }
    }
    for (auto& [shape, solid] : shapes) {
        if (!is_closed(solid.corners)) continue;
        solid.low = solid.high = solid.corners.front();
        for (const glm::dvec3& p : solid.corners) {
            solid.low = glm::min(solid.low, p);
            solid.high = glm::max(solid.high, p);
        }
        bool room = std::any_of(witnesses.begin(), witnesses.end(), [&](const glm::dvec3& w) { return solid.encloses(w); });
        if (!room) solids_.push_back(std::move(solid));
    }
}

bool Solids::contains(const glm::dvec3& point) const {
    return std::any_of(solids_.begin(), solids_.end(), [&](const Solid& s) { return s.encloses(point); });
}

std::vector<float4> place_pencils(const FlatScene& flat, const Solids& solids, Sequence sequence, int count, int set, std::uint64_t seed) {
    const auto stream = static_cast<std::uint64_t>(set);
    const glm::dvec3 shift(random_unit(seed, stream, 0), random_unit(seed, stream, 1), random_unit(seed, stream, 2));
    std::vector<float4> cops;
    cops.reserve(static_cast<std::size_t>(count));
    const std::uint64_t limit = static_cast<std::uint64_t>(count) * kMaxTries;
    for (std::uint64_t i = 0; cops.size() < static_cast<std::size_t>(count); ++i) {
        glm::dvec3 u = sequence == Sequence::low_discrepancy
                           ? r3_sequence(i + 1, shift)
                           : glm::dvec3(random_unit(seed, stream, 3 * i + 3), random_unit(seed, stream, 3 * i + 4), random_unit(seed, stream, 3 * i + 5));
        glm::dvec3 p = flat.low + u * (flat.high - flat.low);
        if (i < limit && solids.contains(p)) continue;
        cops.emplace_back(glm::vec3(p), 0.0F);
    }
    return cops;
}

}  // namespace pencil
