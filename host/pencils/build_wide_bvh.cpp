#include "pencils/build_wide_bvh.h"

#include <algorithm>
#include <cmath>

#include "pencils/bvh_builder.h"

namespace pencil {

namespace {

constexpr BvhShape wide_shape{WIDE_CHILDREN, WIDE_TRIANGLES, WIDE_TRIANGLES, WIDE_MOST_LEVELS};

WideNode empty_wide_node() {
    WideNode node{};
    for (int axis = 0; axis < 3; ++axis)
        for (int k = 0; k < WIDE_CHILDREN; ++k) {
            node.low[axis][k] = INFINITY;
            node.high[axis][k] = -INFINITY;
        }
    return node;
}

WideLeaf leaf_of(const BuildNode& from, const std::vector<Triangle>& triangles, const std::vector<float4>& planes) {
    WideLeaf leaf{};
    std::fill(std::begin(leaf.plane_index), std::end(leaf.plane_index), -1);
    std::fill(std::begin(leaf.triangle), std::end(leaf.triangle), -1);
    for (unsigned k = 0; k < from.count; ++k) {
        const Triangle& t = triangles[from.triangles[k]];
        const float4& plane = planes[static_cast<std::size_t>(t.plane)];
        for (int axis = 0; axis < 4; ++axis) leaf.plane[axis][k] = plane[axis];
        for (int axis = 0; axis < 3; ++axis) {
            leaf.corner[0][axis][k] = t.v0[axis];
            leaf.corner[1][axis][k] = t.v1[axis];
            leaf.corner[2][axis][k] = t.v2[axis];
        }
        leaf.plane_index[k] = t.plane;
        leaf.triangle[k] = static_cast<int>(from.triangles[k]);
    }
    return leaf;
}

class Flattener {
public:
    Flattener(const std::vector<Triangle>& triangles, const std::vector<float4>& planes) : triangles_(triangles), planes_(planes) {
        bvh.leaves.reserve(triangles.size() / 3);
    }

    /// Appends `from`, depth first, and returns its index.
    int add(const BuildNode& from, int level) {
        const std::size_t index = bvh.nodes.size();
        bvh.levels = std::max(bvh.levels, level);
        bvh.nodes.push_back(empty_wide_node());
        for (unsigned k = 0; k < from.children_count; ++k) {
            for (int axis = 0; axis < 3; ++axis) {
                bvh.nodes[index].low[axis][k] = from.boxes[k].low[axis];
                bvh.nodes[index].high[axis][k] = from.boxes[k].high[axis];
            }
            const int child = add_child(*from.children[k], level);  // may move the nodes
            bvh.nodes[index].child[k] = child;
        }
        return static_cast<int>(index);
    }

    WideBvh bvh;

private:
    int add_child(const BuildNode& child, int level) {
        if (child.count == 0) return add(child, level + 1);
        bvh.leaves.push_back(leaf_of(child, triangles_, planes_));
        return ~static_cast<int>(bvh.leaves.size() - 1);
    }

    const std::vector<Triangle>& triangles_;
    const std::vector<float4>& planes_;
};

}  // namespace

WideBvh build_wide_bvh(const std::vector<Triangle>& triangles, const std::vector<float4>& planes) {
    Flattener flattener(triangles, planes);
    if (triangles.empty())
        flattener.bvh.nodes.push_back(empty_wide_node());
    else
        flattener.add(BuiltTree(triangles, wide_shape).root(), 1);
    return std::move(flattener.bvh);
}

}  // namespace pencil
