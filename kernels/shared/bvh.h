// Bounding-volume hierarchy over triangles: two children per node, so that one node decides which of them comes first.
#pragma once

#include "shared/types.h"

// Deepest path from the root to a leaf: the size of the traversal stack.
#define BVH_MOST_LEVELS 48

PENCIL_SHARED_BEGIN

typedef struct BvhNode {
    float4 low[2];  // xyz: bounds of each child [scene units], widened by PLANE_TOLERANCE; w unused
    float4 high[2];
    //------------------------------------------------- 64 B
    int child[2];  // inner child: its node; leaf: its first entry in the list of triangles; empty: -1
    int count[2];  // leaf: number of triangles; inner child or empty: 0
    //------------------------------------------------- 80 B
} BvhNode;

PENCIL_SHARED_END
