// The facets of a render's maps, the parts of a map in which the projection is linear: octants, faces of pyramids, faces of cubes. Their
// texels are disjoint, so a work-item draws into one. The dual paraboloid has none.

#include "lib/map.cl"
#include "lib/octant.cl"
#include "lib/raster.cl"
#include "lib/triangle.cl"
#include "shared/cluster.h"
#include "shared/geometry.h"
#include "shared/map_kind.h"

#define MAP_FACETS PENCIL_MAP_FACETS(PENCIL_MAP_KIND)

#if PENCIL_MAP_KIND == PENCIL_MAP_OCTAHEDRAL
typedef Octant Facet;
#define FACET(name) octant_##name
#elif MAP_FACETS > 0
#if PENCIL_MAP_KIND == PENCIL_MAP_PYRAMID
#include "lib/pyramid_facet.cl"
#else
#include "lib/cube_facet.cl"
#endif
#include "lib/panel_facet.cl"
typedef PanelFacet Facet;
#define FACET(name) panel_facet_##name
#endif

#if MAP_FACETS > 0

/// Facet number `item` % MAP_FACETS of tile `item` / MAP_FACETS behind first_tile, its texels cleared.
static inline Facet facet_begin(int item, global const float4 *cops, int first_tile, int n, global Hit *hits) {
    return FACET(begin)(item, cops, first_tile, n, hits);
}

/// Draws triangle i.
static inline void facet_draw(const Facet *f, global const Triangle *triangles, global const float4 *planes, int i) {
    FACET(draw)(f, triangles, planes, i);
}

/// False if no triangle of the cluster can change what the facet shows.
static inline bool facet_matters(const Facet *f, global const Cluster *cluster) { return FACET(matters)(f, cluster); }

#endif
