// Clusters: small groups of neighbouring triangles with one box each, which the rasteriser may leave out together.
#pragma once

#include "shared/types.h"

// Triangles of a cluster: cluster k has entries k * CLUSTER_TRIANGLES .. of the list of members; the last one may have fewer.
#define CLUSTER_TRIANGLES 16
// Clusters of a group. Groups have boxes too, behind those of all clusters.
#define CLUSTER_GROUP 16

PENCIL_SHARED_BEGIN

typedef struct Cluster {
    float4 low;  // xyz: bounds [scene units], widened by PLANE_TOLERANCE; w unused
    float4 high;
    //------------------------------------------------- 32 B
} Cluster;

PENCIL_SHARED_END
