#include "pencils/bvh_builder.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtx/component_wise.hpp>

#include "util/error.h"

namespace pencil {

namespace {

/// Boxes are wider than their triangles by this, so that rounding cuts nothing off (PLANE_TOLERANCE of kernels/lib/triangle.cl): but for small
/// ones near the eye, this share of their largest coordinate. Rays from centres further away than FAR_CENTRE do not pass by these.
constexpr float widen = 1e-6F, widen_share = 3e-5F;

Box box_of(const RTCBounds& b) {
    const glm::vec3 low(b.lower_x, b.lower_y, b.lower_z), high(b.upper_x, b.upper_y, b.upper_z);
    const float wider = std::min(widen, widen_share * glm::compMax(glm::max(glm::abs(low), glm::abs(high))));
    return {low - wider, high + wider};
}

template <typename T>
T* allocate(RTCThreadLocalAllocator allocator, std::size_t count) {
    // T may be a pointer: nodes hold those of their children.
    return new (rtcThreadLocalAlloc(allocator, count * sizeof(T), alignof(T))) T[count];  // NOLINT(bugprone-sizeof-expression)
}
void* create_node(RTCThreadLocalAllocator allocator, unsigned count, void*) {
    auto* node = allocate<BuildNode>(allocator, 1);
    node->children_count = count;
    node->children = allocate<const BuildNode*>(allocator, count);
    node->boxes = allocate<Box>(allocator, count);
    return node;
}
void set_children(void* node, void** children, unsigned count, void*) {
    for (unsigned k = 0; k < count; ++k) static_cast<BuildNode*>(node)->children[k] = static_cast<BuildNode*>(children[k]);
}
void set_bounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
    for (unsigned k = 0; k < count; ++k) static_cast<BuildNode*>(node)->boxes[k] = box_of(*bounds[k]);
}
void* create_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t count, void*) {
    auto* leaf = allocate<BuildNode>(allocator, 1);
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

RTCBounds bounds_of(const std::vector<Triangle>& triangles) {
    RTCBounds b{INFINITY, INFINITY, INFINITY, 0, -INFINITY, -INFINITY, -INFINITY, 0};
    for (const RTCBuildPrimitive& p : primitives_of(triangles)) {
        b.lower_x = std::min(b.lower_x, p.lower_x);
        b.lower_y = std::min(b.lower_y, p.lower_y);
        b.lower_z = std::min(b.lower_z, p.lower_z);
        b.upper_x = std::max(b.upper_x, p.upper_x);
        b.upper_y = std::max(b.upper_y, p.upper_y);
        b.upper_z = std::max(b.upper_z, p.upper_z);
    }
    return b;
}

}  // namespace

struct BuiltTree::Memory {
    struct Release {
        void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
        void operator()(RTCBVH bvh) const { rtcReleaseBVH(bvh); }
    };
    // One thread: the order of the builder's work, and with it the tree, does not depend on the machine.
    std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device{rtcNewDevice("threads=1")};
    std::unique_ptr<std::remove_pointer_t<RTCBVH>, Release> builder{device ? rtcNewBVH(device.get()) : nullptr};
};

BuiltTree::~BuiltTree() = default;

BuiltTree::BuiltTree(const std::vector<Triangle>& triangles, const BvhShape& shape) : memory_(std::make_unique<Memory>()) {
    std::vector<RTCBuildPrimitive> primitives = primitives_of(triangles);
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.byteSize = sizeof(arguments);
    arguments.maxBranchingFactor = shape.children;
    arguments.maxDepth = shape.most_levels;
    arguments.sahBlockSize = shape.block;
    arguments.minLeafSize = 1;
    arguments.maxLeafSize = shape.leaf_triangles;
    arguments.bvh = memory_->builder.get();
    arguments.primitives = primitives.data();
    arguments.primitiveCount = arguments.primitiveArrayCapacity = primitives.size();
    arguments.createNode = create_node;
    arguments.setNodeChildren = set_children;
    arguments.setNodeBounds = set_bounds;
    arguments.createLeaf = create_leaf;
    root_ = memory_->builder ? static_cast<const BuildNode*>(rtcBuildBVH(&arguments)) : nullptr;
    if (!root_) throw MemoryError(fmt::format("building the hierarchy of {} triangles failed", triangles.size()));
    if (root_->count == 0) return;
    all_ = box_of(bounds_of(triangles));
    above_.children_count = 1;
    above_.children = &only_leaf_;
    above_.boxes = &all_;
    only_leaf_ = root_;
    root_ = &above_;
}

}  // namespace pencil
