#include "pencils/build_bvh.h"

#include <algorithm>
#include <cmath>

#include "pencils/bvh_builder.h"

namespace pencil {

namespace {

/// Packets share the set-up of a triangle, so leaves may be larger than those of single rays.
constexpr BvhShape binary_shape{2, 4, 1, BVH_MOST_LEVELS};

BvhNode empty_node() {
    BvhNode node{};
    for (int k = 0; k < 2; ++k) {
        node.low[k] = float4(INFINITY);
        node.high[k] = float4(-INFINITY);
        node.child[k] = -1;
    }
    return node;
}

/// Appends `from`, depth first, and returns its index.
int add(Bvh& bvh, const BuildNode& from, int level) {
    const std::size_t index = bvh.nodes.size();
    bvh.levels = std::max(bvh.levels, level);
    bvh.nodes.push_back(empty_node());
    for (unsigned k = 0; k < from.children_count; ++k) {
        const BuildNode& child = *from.children[k];
        bvh.nodes[index].low[k] = float4(from.boxes[k].low, 0.0F);
        bvh.nodes[index].high[k] = float4(from.boxes[k].high, 0.0F);
        bvh.nodes[index].count[k] = static_cast<int>(child.count);
        if (child.count > 0) {
            bvh.nodes[index].child[k] = static_cast<int>(bvh.leaves.size());
            bvh.leaves.insert(bvh.leaves.end(), child.triangles, child.triangles + child.count);
        } else {
            const int added = add(bvh, child, level + 1);  // may move the nodes
            bvh.nodes[index].child[k] = added;
        }
    }
    return static_cast<int>(index);
}

}  // namespace

Bvh build_bvh(const std::vector<Triangle>& triangles) {
    Bvh bvh;
    if (triangles.empty()) {
        bvh.nodes.push_back(empty_node());
        return bvh;
    }
    add(bvh, BuiltTree(triangles, binary_shape).root(), 1);
    return bvh;
}

}  // namespace pencil
