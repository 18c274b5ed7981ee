// Neighbouring triangles in clusters, for the rasteriser of geometry maps.
#pragma once

#include <vector>

#include "shared/cluster.h"
#include "shared/geometry.h"

namespace pencil {

struct Clusters {
    int count = 0;               // clusters
    std::vector<Cluster> boxes;  // of the clusters, then of groups of CLUSTER_GROUP clusters
    std::vector<int> members;    // triangles of one cluster after the other, ascending within each
};

/// Triangles of like size along a Morton curve, CLUSTER_TRIANGLES by CLUSTER_TRIANGLES. Much cheaper than a hierarchy: one sort.
Clusters cluster_triangles(const std::vector<Triangle>& triangles);

}  // namespace pencil
