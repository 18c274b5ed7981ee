#include "scene/gltf/read_primitive.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <numeric>
#include <optional>

#include "scene/meshes/nowhere.h"

namespace pencil {
namespace {

class PrimitiveReader {
public:
    PrimitiveReader(GltfFile& file, const tinygltf::Primitive& primitive, const std::string& label)
        : file_(file), accessors_(file), primitive_(primitive), label_(label) {}

    Mesh read(int uv_set) {
        const int mode = primitive_.mode;
        if (mode != TINYGLTF_MODE_TRIANGLES && mode != TINYGLTF_MODE_TRIANGLE_STRIP && mode != TINYGLTF_MODE_TRIANGLE_FAN) {
            file_.approximate("points and lines are left out");
            return {};
        }
        if (!primitive_.targets.empty()) file_.approximate("morph targets are left out: shapes stand as they are at rest");
        positions();
        normals();
        texture_coordinates("TEXCOORD_" + std::to_string(uv_set));
        colours();
        triangles();
        leave_out_nowhere(nowhere_, mesh_);
        for (const std::string& note : mesh_.notes) file_.approximate(label_ + ": " + note);
        return std::move(mesh_);
    }

private:
    std::optional<int> attribute(const std::string& name) const {
        const auto place = primitive_.attributes.find(name);
        return place == primitive_.attributes.end() ? std::nullopt : std::optional<int>(place->second);
    }

    /// As many elements as there are positions.
    std::vector<double> numbers(int accessor, int components, const char* what) const {
        std::vector<double> values = accessors_.numbers(accessor, components, label_);
        const std::size_t count = values.size() / static_cast<std::size_t>(components);
        if (count != mesh_.positions.size()) {
            file_.fail(label_ + " has " + std::to_string(count) + " " + what + " for " + std::to_string(mesh_.positions.size()) +
                       " positions");
        }
        return values;
    }

    void positions() {
        const std::optional<int> accessor = attribute("POSITION");
        if (!accessor) file_.fail(label_ + " has no positions");
        const std::vector<double> values = accessors_.numbers(*accessor, 3, label_);
        mesh_.positions.reserve(values.size() / 3);
        for (std::size_t i = 0; i < values.size(); i += 3) {
            const glm::dvec3 position(values[i], values[i + 1], values[i + 2]);
            if (!is_finite(position)) nowhere_.push_back(static_cast<std::uint32_t>(mesh_.positions.size()));
            mesh_.positions.push_back(is_finite(position) ? position : glm::dvec3(0.0));
        }
        check_bounds(file_.model().accessors[static_cast<std::size_t>(*accessor)]);
    }

    /// Files say where their vertices lie. A little more is rounding; more than as much again is damage.
    void check_bounds(const tinygltf::Accessor& accessor) {
        if (accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT || accessor.minValues.size() != 3 || accessor.maxValues.size() != 3)
            return;
        const glm::dvec3 low(accessor.minValues[0], accessor.minValues[1], accessor.minValues[2]);
        const glm::dvec3 high(accessor.maxValues[0], accessor.maxValues[1], accessor.maxValues[2]);
        const double size = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
        if (!(size > 0.0) || !std::isfinite(size)) return;
        const auto outside = std::count_if(mesh_.positions.begin(), mesh_.positions.end(), [&](const glm::dvec3& p) {
            return glm::any(glm::lessThan(p, low - size)) || glm::any(glm::greaterThan(p, high + size));
        });
        if (outside > 0) {
            file_.warn(label_ + ": " + std::to_string(outside) +
                       " vertices lie far outside the bounds that the file gives (min and max of its accessor): is its buffer damaged?");
        }
    }

    /// What is no direction is no normal: the face's own is used there.
    void normals() {
        const std::optional<int> accessor = attribute("NORMAL");
        if (!accessor) return;
        const std::vector<double> values = numbers(*accessor, 3, "normals");
        std::size_t bad = 0;
        for (std::size_t i = 0; i < values.size(); i += 3) {
            const glm::dvec3 normal(values[i], values[i + 1], values[i + 2]);
            if (!is_finite(normal)) ++bad;
            mesh_.normals.push_back(is_finite(normal) ? normal : glm::dvec3(0.0));
        }
        if (bad > 0) file_.approximate(label_ + ": " + std::to_string(bad) + " normals that are not finite are left out");
    }

    void texture_coordinates(const std::string& name) {
        const std::optional<int> accessor = attribute(name);
        if (!accessor) return;
        const std::vector<double> values = numbers(*accessor, 2, "texture coordinates");
        const auto finite = [](double value) { return std::isfinite(value) ? static_cast<float>(value) : 0.0F; };
        for (std::size_t i = 0; i < values.size(); i += 2) mesh_.uvs.emplace_back(finite(values[i]), finite(values[i + 1]));
    }

    /// White ones, which many exporters write, are as good as none.
    void colours() {
        const std::optional<int> accessor = attribute("COLOR_0");
        if (!accessor) return;
        const int components = std::max(accessors_.components(*accessor, label_), 3);
        const std::vector<double> values = numbers(*accessor, components, "colours");
        bool is_white = true, is_opaque = true;
        for (std::size_t i = 0; i < values.size(); i += static_cast<std::size_t>(components)) {
            glm::vec3 colour(0.0F);
            for (int c = 0; c < 3; ++c) {
                const double value = values[i + static_cast<std::size_t>(c)];
                if (std::isfinite(value)) colour[c] = static_cast<float>(std::clamp(value, 0.0, 1.0));
            }
            mesh_.colours.push_back(colour);
            is_white = is_white && colour == glm::vec3(1.0F);
            is_opaque = is_opaque && (components < 4 || values[i + 3] >= 1.0);
        }
        if (is_white) mesh_.colours.clear();
        if (!is_opaque) file_.approximate(label_ + ": the opacity of its vertices is left out");
    }

    void triangles() {
        std::vector<std::uint32_t> order;
        if (primitive_.indices >= 0) {
            order = accessors_.indices(primitive_.indices, label_);
            for (const std::uint32_t index : order) {
                if (index >= mesh_.positions.size()) {
                    file_.fail(label_ + " names vertex " + std::to_string(index) + ", but there are " +
                               std::to_string(mesh_.positions.size()));
                }
            }
        } else {
            order.resize(mesh_.positions.size());
            std::iota(order.begin(), order.end(), 0U);
        }
        const std::size_t n = order.size();
        if (primitive_.mode == TINYGLTF_MODE_TRIANGLES) {
            if (n % 3 != 0) file_.warn(label_ + ": the last triangle lacks corners and is left out");
            for (std::size_t i = 2; i < n; i += 3) mesh_.triangles.emplace_back(order[i - 2], order[i - 1], order[i]);
        } else if (primitive_.mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
            for (std::size_t i = 2; i < n; ++i) {  // every other one is wound the other way round
                const std::size_t odd = i % 2;
                mesh_.triangles.emplace_back(order[i - 2], order[i - 1 + odd], order[i - odd]);
            }
        } else {
            for (std::size_t i = 2; i < n; ++i) mesh_.triangles.emplace_back(order[i - 1], order[i], order[0]);
        }
    }

    GltfFile& file_;
    AccessorReader accessors_;
    const tinygltf::Primitive& primitive_;
    const std::string& label_;
    Mesh mesh_;
    std::vector<std::uint32_t> nowhere_;  // vertices
};

}  // namespace

Mesh read_primitive(GltfFile& file, const tinygltf::Primitive& primitive, int uv_set, const std::string& label) {
    return PrimitiveReader(file, primitive, label).read(uv_set);
}

}  // namespace pencil
