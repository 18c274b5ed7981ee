// Placement: positions by the transform, normals by its inverse transpose, winding so that it agrees with the normals.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "scene/mesh.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr double max_coordinate = 1e18;  // its square is still within single precision
constexpr std::uint32_t not_placed = std::numeric_limits<std::uint32_t>::max();

glm::dvec3 unit_or_zero(glm::dvec3 v) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
}

class Placer {
public:
    Placer(const Mesh& mesh, const Placement& placement, const std::string& where, Scene& scene)
        : mesh_(mesh),
          placement_(placement),
          where_(where),
          scene_(scene),
          has_normals_(!mesh.normals.empty() && !placement.face_normals),
          placed_(mesh.positions.size(), not_placed) {
        const glm::dmat3 linear(placement.to_world);
        const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]), glm::cross(linear[0], linear[1]));
        mirrors_ = glm::dot(linear[0], cofactors[0]) < 0.0;
        // The cofactor matrix is the inverse transpose times the determinant; its sign is undone here, its scale by normalising.
        normal_to_world_ = cofactors * (mirrors_ ? -1.0 : 1.0) * (placement.flip_normals ? -1.0 : 1.0);
        world_.reserve(mesh.positions.size());
        for (const glm::dvec3& position : mesh.positions) world_.push_back(to_world(position));
    }

    PlacementCounts place(std::uint32_t shape) {
        PlacementCounts counts;
        for (glm::uvec3 corners : mesh_.triangles) {
            if (mirrors_ != placement_.flip_normals) std::swap(corners.y, corners.z);
            const glm::dvec3 normal = face_normal(corners);
            if (normal == glm::dvec3(0.0)) {
                ++counts.dropped;
                continue;
            }
            if (has_normals_ && glm::dot(normal, normal_at(corners.x) + normal_at(corners.y) + normal_at(corners.z)) < 0.0) {
                std::swap(corners.y, corners.z);
                ++counts.turned;
            }
            if (scene_.triangles.size() >= max_triangles) {
                throw SceneError(where_, "the scene has more than " + std::to_string(max_triangles) + " triangles");
            }
            scene_.triangles.push_back({{vertex(corners.x), vertex(corners.y), vertex(corners.z)}, shape});
        }
        return counts;
    }

private:
    glm::dvec3 to_world(glm::dvec3 position) const {
        const glm::dvec3 p(placement_.to_world * glm::dvec4(position, 1.0));
        if (!(std::abs(p.x) <= max_coordinate && std::abs(p.y) <= max_coordinate && std::abs(p.z) <= max_coordinate)) {
            throw SceneError(where_, "a vertex lies further than 1e18 from the origin");
        }
        return p;
    }

    glm::dvec3 normal_at(std::uint32_t i) const { return unit_or_zero(normal_to_world_ * mesh_.normals[i]); }

    /// Zero if the area is zero up to the rounding of the edges' coordinates.
    glm::dvec3 face_normal(glm::uvec3 corners) const {
        const glm::dvec3 a = world_[corners.y] - world_[corners.x];
        const glm::dvec3 b = world_[corners.z] - world_[corners.x];
        const double longest = std::max(glm::length(a), glm::length(b));
        if (!(longest > 0.0)) return glm::dvec3(0.0);
        const glm::dvec3 normal = glm::cross(a / longest, b / longest);
        constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
        return glm::length(normal) > rounding ? normal : glm::dvec3(0.0);
    }

    std::uint32_t vertex(std::uint32_t i) {
        if (placed_[i] == not_placed) {
            placed_[i] = static_cast<std::uint32_t>(scene_.positions.size());
            scene_.positions.push_back(world_[i]);
            scene_.normals.push_back(has_normals_ ? glm::vec3(normal_at(i)) : glm::vec3(0.0F));
        }
        return placed_[i];
    }

    const Mesh& mesh_;
    const Placement& placement_;
    const std::string& where_;
    Scene& scene_;
    bool has_normals_;
    bool mirrors_ = false;
    glm::dmat3 normal_to_world_{1.0};
    std::vector<std::uint32_t> placed_;
    std::vector<glm::dvec3> world_;
};

}  // namespace

PlacementCounts place_mesh(const Mesh& mesh, const Placement& placement, std::uint32_t shape, const std::string& where, Scene& scene) {
    return Placer(mesh, placement, where, scene).place(shape);
}

}  // namespace pencil
