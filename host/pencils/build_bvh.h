// A bounding-volume hierarchy for the kernels, built by Embree's builder.
#pragma once

#include <vector>

#include "pencils/flat_scene.h"
#include "shared/bvh.h"

namespace pencil {

struct Bvh {
    std::vector<BvhNode> nodes;  // the root is first
    std::vector<int> leaves;     // triangles of the leaves, one leaf after the other
    int levels = 0;              // nodes on the longest path
};

/// Surface-area heuristic; the same triangles give the same hierarchy. No triangles: one node with empty children. MemoryError if the
/// builder runs out of memory.
Bvh build_bvh(const std::vector<Triangle>& triangles);

}  // namespace pencil
