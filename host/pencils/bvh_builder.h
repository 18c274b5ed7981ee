// Trees of boxes over triangles, by Embree's builder.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "pencils/flat_scene.h"

namespace pencil {

/// What Embree is asked for.
struct BvhShape {
    unsigned children;        // of a node, at most 8
    unsigned leaf_triangles;  // at most 4
    unsigned block;           // triangles that cost as much as one
    unsigned most_levels;
};

struct Box {
    glm::vec3 low, high;
};

/// Node of a tree: inner (children with their boxes, which hold what rounding would cut off) or leaf (its triangles).
struct BuildNode {
    unsigned children_count = 0, count = 0;
    const BuildNode** children = nullptr;
    Box* boxes = nullptr;
    unsigned triangles[4] = {};
};

/// Holds the memory of its nodes.
class BuiltTree {
public:
    /// Surface-area heuristic; the same triangles give the same tree. There are some. MemoryError if the builder runs out of memory.
    BuiltTree(const std::vector<Triangle>& triangles, const BvhShape& shape);
    ~BuiltTree();
    BuiltTree(const BuiltTree&) = delete;
    BuiltTree& operator=(const BuiltTree&) = delete;

    /// An inner node: with one child where the tree is no more than a leaf.
    const BuildNode& root() const { return *root_; }

private:
    struct Memory;
    std::unique_ptr<Memory> memory_;
    const BuildNode *root_ = nullptr, *only_leaf_ = nullptr;
    BuildNode above_;  // of a leaf that is all
    Box all_{};
};

}  // namespace pencil
