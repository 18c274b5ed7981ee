// A hierarchy of eight children per node for the kernels, built by Embree's builder: where there are many triangles (shared/bvh.h).
#pragma once

#include <vector>

#include "pencils/flat_scene.h"
#include "shared/bvh.h"

namespace pencil {

struct WideBvh {
    std::vector<WideNode> nodes;  // the root is first
    std::vector<WideLeaf> leaves;
    int levels = 0;  // nodes on the longest path
};

/// As build_bvh. `planes`: of the triangles.
WideBvh build_wide_bvh(const std::vector<Triangle>& triangles, const std::vector<float4>& planes);

}  // namespace pencil
