#include "scene/gltf/node_tree.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>

namespace pencil {
namespace {

/// The node's own transformation: a matrix by columns, or translation * rotation * scale.
glm::dmat4 local_transform(const GltfFile& file, const tinygltf::Node& node, const std::string& label) {
    const auto check = [&](const std::vector<double>& numbers, std::size_t count, const char* what) {
        if (!numbers.empty() && numbers.size() != count)
            file.fail(label + ": " + what + " has " + std::to_string(numbers.size()) + " numbers, not " + std::to_string(count));
        return !numbers.empty();
    };
    glm::dmat4 result(1.0);
    if (check(node.matrix, 16, "matrix")) {
        for (int i = 0; i < 16; ++i) result[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        if (result[0][3] != 0 || result[1][3] != 0 || result[2][3] != 0 || result[3][3] != 1)
            file.fail(label + ": the matrix has a last row other than 0 0 0 1");
        return result;
    }
    if (check(node.translation, 3, "translation"))
        result = glm::translate(result, glm::dvec3(node.translation[0], node.translation[1], node.translation[2]));
    if (check(node.rotation, 4, "rotation")) {
        const glm::dquat rotation(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
        if (!(glm::length(rotation) > 0)) file.fail(label + ": the rotation is zero");
        result *= glm::mat4_cast(glm::normalize(rotation));
    }
    if (check(node.scale, 3, "scale")) result = glm::scale(result, glm::dvec3(node.scale[0], node.scale[1], node.scale[2]));
    return result;
}

/// Nodes that are no other's child.
std::vector<int> roots_of(const tinygltf::Model& model) {
    std::vector<bool> is_child(model.nodes.size(), false);
    for (const tinygltf::Node& node : model.nodes)
        for (const int child : node.children)
            if (child >= 0 && static_cast<std::size_t>(child) < is_child.size()) is_child[static_cast<std::size_t>(child)] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i)
        if (!is_child[i]) roots.push_back(static_cast<int>(i));
    return roots;
}

}  // namespace

void visit_nodes(const GltfFile& file, const NodeVisitor& visit) {
    const tinygltf::Model& model = file.model();
    const int scene = model.defaultScene >= 0 ? model.defaultScene : 0;
    const std::vector<int> roots =
        model.scenes.empty() && model.defaultScene < 0 ? roots_of(model) : file.at(model.scenes, scene, "scene", "the file").nodes;
    std::vector<std::pair<int, glm::dmat4>> open;  // with the parent's place; a list and no recursion: chains may be long
    for (auto root = roots.rbegin(); root != roots.rend(); ++root) open.emplace_back(*root, glm::dmat4(1.0));
    std::vector<bool> seen(model.nodes.size(), false);
    while (!open.empty()) {
        const auto [index, parent] = open.back();
        open.pop_back();
        const tinygltf::Node& node = file.at(model.nodes, index, "node", "the scene");
        const auto number = static_cast<std::size_t>(index);
        const std::string label = named("node", number, node.name);
        if (seen[number]) file.fail(label + " is reached twice: nodes must form a tree");
        seen[number] = true;
        const glm::dmat4 to_world = parent * local_transform(file, node, label);
        visit(number, to_world);
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) open.emplace_back(*child, to_world);
    }
}

}  // namespace pencil
