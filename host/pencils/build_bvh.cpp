#include "pencils/build_bvh.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtx/component_wise.hpp>
#include <memory>

#include "util/error.h"

namespace pencil {

namespace {

/// Boxes are wider than their triangles by this, so that rounding cuts nothing off (PLANE_TOLERANCE of kernels/lib/triangle.cl): but for small
/// ones near the eye, this share of their largest coordinate. Rays from centres further away than FAR_CENTRE do not pass by these.
constexpr float widen = 1e-6F, widen_share = 3e-5F;
/// Packets share the set-up of a triangle, so leaves may be larger than those of single rays.
constexpr unsigned leaf_triangles = 4;

/// Node of the builder: inner (two children with bounds) or leaf (its triangles).
struct BuildNode {
    BuildNode* children[2] = {nullptr, nullptr};
    RTCBounds bounds[2]{};
    unsigned count = 0;
    unsigned triangles[leaf_triangles]{};
};

void* create_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(BuildNode), alignof(BuildNode))) BuildNode;
}
void set_children(void* node, void** children, unsigned count, void*) {
    for (unsigned k = 0; k < count; ++k) static_cast<BuildNode*>(node)->children[k] = static_cast<BuildNode*>(children[k]);
}
void set_bounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
    for (unsigned k = 0; k < count; ++k) static_cast<BuildNode*>(node)->bounds[k] = *bounds[k];
}
void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t count, void*) {
    auto* leaf = new (rtcThreadLocalAlloc(allocator, sizeof(BuildNode), alignof(BuildNode))) BuildNode;
    leaf->count = static_cast<unsigned>(count);
    for (std::size_t k = 0; k < count; ++k) leaf->triangles[k] = primitives[k].primID;
    return leaf;
}

std::vector<RTCBuildPrimitive> primitives_of(const std::vector<Triangle>& triangles) {
    std::vector<RTCBuildPrimitive> primitives(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        const float4 low = glm::min(glm::min(t.v0, t.v1), t.v2), high = glm::max(glm::max(t.v0, t.v1), t.v2);
        primitives[i] = {low.x, low.y, low.z, 0, high.x, high.y, high.z, static_cast<unsigned>(i)};
    }
    return primitives;
}

RTCBounds bounds_of(const std::vector<RTCBuildPrimitive>& primitives) {
    RTCBounds b{INFINITY, INFINITY, INFINITY, 0, -INFINITY, -INFINITY, -INFINITY, 0};
    for (const RTCBuildPrimitive& p : primitives) {
        b.lower_x = std::min(b.lower_x, p.lower_x);
        b.lower_y = std::min(b.lower_y, p.lower_y);
        b.lower_z = std::min(b.lower_z, p.lower_z);
        b.upper_x = std::max(b.upper_x, p.upper_x);
        b.upper_y = std::max(b.upper_y, p.upper_y);
        b.upper_z = std::max(b.upper_z, p.upper_z);
    }
    return b;
}

BvhNode empty_node() {
    BvhNode node{};
    for (int k = 0; k < 2; ++k) {
        node.low[k] = float4(INFINITY);
        node.high[k] = float4(-INFINITY);
        node.child[k] = -1;
    }
    return node;
}

class Flattener {
public:
    explicit Flattener(Bvh& bvh) : bvh_(bvh) {}

    /// Appends the children of `from` as one node, depth first, and returns its index.
    int add(const BuildNode& from, int level) {
        const int index = static_cast<int>(bvh_.nodes.size());
        bvh_.levels = std::max(bvh_.levels, level);
        bvh_.nodes.push_back(empty_node());
        for (int k = 0; k < 2; ++k)
            if (from.children[k]) add_child(index, k, from.bounds[k], *from.children[k], level);
        return index;
    }

    void add_child(int index, int k, const RTCBounds& b, const BuildNode& child, int level) {
        BvhNode& node = bvh_.nodes[static_cast<std::size_t>(index)];
        const glm::vec3 low(b.lower_x, b.lower_y, b.lower_z), high(b.upper_x, b.upper_y, b.upper_z);
        const float wider = std::min(widen, widen_share * glm::compMax(glm::max(glm::abs(low), glm::abs(high))));
        node.low[k] = float4(low - wider, 0.0F);
        node.high[k] = float4(high + wider, 0.0F);
        if (child.count > 0) {
            node.child[k] = static_cast<int>(bvh_.leaves.size());
            node.count[k] = static_cast<int>(child.count);
            bvh_.leaves.insert(bvh_.leaves.end(), child.triangles, child.triangles + child.count);
        } else {
            const int added = add(child, level + 1);  // may move the nodes
            bvh_.nodes[static_cast<std::size_t>(index)].child[k] = added;
        }
    }

private:
    Bvh& bvh_;
};

struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCBVH bvh) const { rtcReleaseBVH(bvh); }
};

}  // namespace

Bvh build_bvh(const std::vector<Triangle>& triangles) {
    Bvh bvh;
    if (triangles.empty()) {
        bvh.nodes.push_back(empty_node());
        return bvh;
    }
    // One thread: the order of the builder's work, and with it the hierarchy, does not depend on the machine.
    const std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device(rtcNewDevice("threads=1"));
    const std::unique_ptr<std::remove_pointer_t<RTCBVH>, Release> builder(device ? rtcNewBVH(device.get()) : nullptr);
    std::vector<RTCBuildPrimitive> primitives = primitives_of(triangles);
    const RTCBounds bounds = bounds_of(primitives);
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.byteSize = sizeof(arguments);
    arguments.maxBranchingFactor = 2;
    arguments.maxDepth = BVH_MOST_LEVELS;
    arguments.minLeafSize = 1;
    arguments.maxLeafSize = leaf_triangles;
    arguments.bvh = builder.get();
    arguments.primitives = primitives.data();
    arguments.primitiveCount = arguments.primitiveArrayCapacity = primitives.size();
    arguments.createNode = create_node;
    arguments.setNodeChildren = set_children;
    arguments.setNodeBounds = set_bounds;
    arguments.createLeaf = create_leaf;
    const auto* root = builder ? static_cast<const BuildNode*>(rtcBuildBVH(&arguments)) : nullptr;
    if (!root) throw MemoryError(fmt::format("building the hierarchy of {} triangles failed", triangles.size()));
    Flattener flattener(bvh);
    if (root->count > 0) {
        bvh.nodes.push_back(empty_node());
        bvh.levels = 1;
        flattener.add_child(0, 0, bounds, *root, 1);
    } else {
        flattener.add(*root, 1);
    }
    return bvh;
}

}  // namespace pencil
