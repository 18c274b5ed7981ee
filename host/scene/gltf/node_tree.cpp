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

constexpr std::size_t most_visits = 1'000'000;

enum class State { unseen, inside, left };

/// A node that is to be visited, below its parent's place, or one that is left when all below it has been.
struct Open {
    int node;
    glm::dmat4 parent;
    bool leaves = false;
};

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

void visit_nodes(GltfFile& file, const NodeVisitor& visit) {
    const tinygltf::Model& model = file.model();
    const int scene = model.defaultScene >= 0 ? model.defaultScene : 0;
    const std::vector<int> roots =
        model.scenes.empty() && model.defaultScene < 0 ? roots_of(model) : file.at(model.scenes, scene, "scene", "the file").nodes;
    std::vector<Open> open;  // a list and no recursion: chains may be long
    for (auto root = roots.rbegin(); root != roots.rend(); ++root) open.push_back({*root, glm::dmat4(1.0)});
    std::vector<State> states(model.nodes.size(), State::unseen);
    std::size_t visits = 0;
    while (!open.empty()) {
        const Open next = open.back();
        open.pop_back();
        if (next.leaves) {
            states[static_cast<std::size_t>(next.node)] = State::left;
            continue;
        }
        const tinygltf::Node& node = file.at(model.nodes, next.node, "node", "the scene");
        const auto number = static_cast<std::size_t>(next.node);
        const std::string label = named("node", number, node.name);
        if (states[number] == State::inside) file.fail(label + " lies within itself");
        if (states[number] == State::left) file.approximate(label + " has more than one parent, which glTF forbids: it is shown at each");
        if (++visits > most_visits) file.fail("nodes are shown more than " + std::to_string(most_visits) + " times");
        states[number] = State::inside;
        const glm::dmat4 to_world = next.parent * local_transform(file, node, label);
        visit(number, to_world);
        open.push_back({next.node, to_world, true});
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) open.push_back({*child, to_world});
    }
}

}  // namespace pencil
