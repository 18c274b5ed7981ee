// Bounding-volume hierarchies over triangles. Two children per node for packets of rays, so that one node decides which of them comes first;
// eight for rays that part soon, each alone (PENCIL_WIDE_BVH).
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
PENCIL_SHARED_TYPE(BvhNode)

#define WIDE_CHILDREN 8
#define WIDE_TRIANGLES 4
// The same of the wide hierarchy. Its stack holds seven siblings of each node of a path at most.
#define WIDE_MOST_LEVELS 32

typedef struct WideNode {
    float low[3][WIDE_CHILDREN];  // x, y, z: bounds of each child, as those of BvhNode; empty child: infinity, and less than that
    float high[3][WIDE_CHILDREN];
    //------------------------------------------------- 192 B
    int child[WIDE_CHILDREN];  // inner child: its node; leaf: ~ its number
    //------------------------------------------------- 224 B
} WideNode;
PENCIL_SHARED_TYPE(WideNode)

// What rays need of the triangles of a leaf, side by side. Missing ones have a plane of zeros, which no ray meets.
typedef struct WideLeaf {
    float plane[4][WIDE_TRIANGLES];
    int plane_index[WIDE_TRIANGLES];
    int triangle[WIDE_TRIANGLES];
    //------------------------------------------------- 96 B
    float corner[3][3][WIDE_TRIANGLES];  // v0, v1, v2; x, y, z [scene units]
    //------------------------------------------------- 240 B
} WideLeaf;
PENCIL_SHARED_TYPE(WideLeaf)

PENCIL_SHARED_END

#ifdef __OPENCL_C_VERSION__
// Those of the hierarchy that a program is built for.
#if PENCIL_WIDE_BVH
typedef WideNode HierarchyNode;
typedef WideLeaf HierarchyLeaf;
#else
typedef BvhNode HierarchyNode;
typedef int HierarchyLeaf;
#endif
#define HIERARCHY_PARAMETERS global const HierarchyNode *nodes, global const HierarchyLeaf *leaves
#endif
