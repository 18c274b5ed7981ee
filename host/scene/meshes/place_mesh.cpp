// Placement: positions by the transform, given normals by its inverse transpose, winding so that it agrees with them. Computed normals come
// from the placed triangles.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "scene/meshes/mesh.h"
#include "scene/meshes/vertex_normals.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr double max_coordinate = 1e18;  // its square is still within single precision
/// Volume of the unit cube's image relative to its edges below which it is none, and the winding alone tells the front.
constexpr double flat = 1e-12;
constexpr std::uint32_t not_placed = std::numeric_limits<std::uint32_t>::max();

glm::dvec3 unit_or_zero(glm::dvec3 v) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
}

class Placer {
public:
    Placer(const Mesh& mesh, const MeshPlacement& placement, const std::string& where, Scene& scene)
        : mesh_(mesh), placement_(placement), where_(where), scene_(scene), placed_(mesh.positions.size(), not_placed) {
        const glm::dmat3 linear(placement.to_world);
        const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]), glm::cross(linear[0], linear[1]));
        const double edges = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
        mirrors_ = glm::dot(linear[0], cofactors[0]) < -flat * edges;
        world_.reserve(mesh.positions.size());
        for (const glm::dvec3& position : mesh.positions) world_.push_back(to_world(position));
        if (placement.face_normals) return;
        // The cofactor matrix is the inverse transpose times the determinant; its sign is undone here, its scale by normalising.
        transform_normals(cofactors * (mirrors_ ? -1.0 : 1.0) * (placement.flip_normals ? -1.0 : 1.0));
        if (mesh.normals.empty() && mesh.smooth) compute_normals();
    }

    PlacementCounts place(Owner owner) {
        PlacementCounts counts;
        for (glm::uvec3 corners : mesh_.triangles) {
            if (turns()) std::swap(corners.y, corners.z);
            const glm::dvec3 normal = face_normal(corners);
            if (normal == glm::dvec3(0.0)) {
                ++counts.dropped;
                continue;
            }
            if (!mesh_.normals.empty() && !normals_.empty() &&
                glm::dot(normal, normals_[corners.x] + normals_[corners.y] + normals_[corners.z]) < 0.0) {
                std::swap(corners.y, corners.z);
                ++counts.turned;
            }
            scene_.triangles.push_back({{vertex(corners.x), vertex(corners.y), vertex(corners.z)}, owner.shape, owner.material});
        }
        return counts;
    }

private:
    glm::dvec3 to_world(glm::dvec3 position) const {
        const glm::dvec3 p(placement_.to_world * glm::dvec4(position, 1.0));
        if (!(std::abs(p.x) <= max_coordinate && std::abs(p.y) <= max_coordinate && std::abs(p.z) <= max_coordinate))
            throw SceneError(where_, "a vertex lies further than 1e18 from the origin");
        return p;
    }

    bool turns() const { return mirrors_ != placement_.flip_normals; }

    void transform_normals(const glm::dmat3& normal_to_world) {
        normals_.reserve(mesh_.normals.size());
        for (const glm::dvec3& normal : mesh_.normals) normals_.push_back(unit_or_zero(normal_to_world * normal));
    }

    /// Leaves the mesh without normals if they would change nothing, as for single polygons.
    void compute_normals() {
        constexpr double unseen = 1e-6;  // single precision
        std::vector<glm::uvec3> triangles = mesh_.triangles;
        if (turns())
            for (glm::uvec3& corners : triangles) std::swap(corners.y, corners.z);
        normals_ = smooth_normals(world_, triangles);
        if (are_face_normals(normals_, world_, triangles, unseen)) normals_.clear();
    }

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
            scene_.normals.push_back(normals_.empty() ? glm::vec3(0.0F) : glm::vec3(normals_[i]));
            add_attribute(mesh_.uvs, i, glm::vec2(0.0F), scene_.uvs);
            add_attribute(mesh_.colours, i, glm::vec3(1.0F), scene_.colours);
        }
        return placed_[i];
    }

    /// The first shape with such values fills up those of the vertices before with `none`.
    template <class T>
    void add_attribute(const std::vector<T>& of_mesh, std::uint32_t i, const T& none, std::vector<T>& of_scene) const {
        if (of_mesh.empty() && of_scene.empty()) return;
        of_scene.resize(scene_.positions.size(), none);
        if (!of_mesh.empty()) of_scene.back() = of_mesh[i];
    }

    const Mesh& mesh_;
    const MeshPlacement& placement_;
    const std::string& where_;
    Scene& scene_;
    bool mirrors_ = false;
    std::vector<std::uint32_t> placed_;
    std::vector<glm::dvec3> world_, normals_;  // of the mesh's vertices, in the world; no normals: none
};

}  // namespace

PlacementCounts place_mesh(const Mesh& mesh, const MeshPlacement& placement, Owner owner, const std::string& where, Scene& scene) {
    if (mesh.triangles.size() > max_triangles - scene.triangles.size())
        throw SceneError(where, "the scene has more than " + std::to_string(max_triangles) + " triangles");
    return Placer(mesh, placement, where, scene).place(owner);
}

}  // namespace pencil
