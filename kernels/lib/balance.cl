// How densely directions lie in which light is known: lines through pencils, and rays that the surfel sends by the cosine. Where a wall is
// near no pencil lies in between, and rays do the work; far things are left to pencils.

#include "lib/packet.cl"

/// Density per solid angle of the direction to a pencil whose centre is uniform in `volume`, for a free path of length d: thesis eq. (5.20)
/// put right.
#define FREE_PATH_DENSITY(d, volume) ((d) * (d) * (d) / (3.0f * (volume)))

/// Areas of discs in terms of the mean area of a direction. A disc of exactly this area would leave cells of the crowd that reach over the
/// edge: the rare are strewn, not placed. Measured on walls, slits and corners (docs/accuracy.md).
#define DISC_AREA 1.25f
/// Discs hold at most so many times the mean cell of the rays alone.
#define MOST_CELLS 4.0f

/// Half the square of the radius of a disc on the sphere that holds one direction, of `pencils` lines of density p each and `rays` rays: where
/// directions are rare on one side of an edge and crowded on the other, the border of their cells is to lie at the edge. The balance
/// heuristic (Veach and Guibas 1995) in the form of cells.
static inline vfloat cell_radius(vfloat p, vfloat cosine, float pencils, float rays) {
    vfloat density = fmax(fma((vfloat)(M_PI_F * pencils), p, rays * cosine), (vfloat)(1e-6f));
    return 0.5f * fmin(DISC_AREA / density, (vfloat)(MOST_CELLS / rays));
}
