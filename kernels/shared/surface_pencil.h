// A pencil on a surface: the hemisphere seen from a surfel, and how far its irradiance may be reused. The irradiance itself is in a buffer
// beside the pencils: irradiance[pencil], rgb [W m^-2], w 0.
#pragma once

#include "shared/types.h"

#define RING_SECTORS 8         // of azimuth about the normal
#define LINK_LAST_RESORT (-2)  // second link of a surfel whose first pencil stands for it only because no other does

PENCIL_SHARED_BEGIN

typedef struct SurfacePencil {
    float4 position;  // xyz [scene units]; w: harmonic mean of the distances seen [scene units], INFINITY if nothing is
    float4 normal;    // xyz: unit shading normal of the seen side; w: radius within which it may be used [scene units]
    float4 facing;    // xyz: unit geometric normal of that side; w unused
    //------------------------------------------------- 48 B
    // What stands at the horizon of each sector, the nearest plane and then the next: points p of the tangent plane with
    // p.x horizon_x + p.y horizon_y >= 1 are behind it; 0 if there is none [1 / scene units]
    float horizon_x[2 * RING_SECTORS];
    float horizon_y[2 * RING_SECTORS];
    //------------------------------------------------- 176 B
    int plane;    // of the surface that it lies on: index into planes
    uint key;     // decides where in its texels the points lie that it sees
    int spacing;  // at which it joined the lattice of film pencils [pixels]; 0 if it lies on none
    int unused;
    //------------------------------------------------- 192 B
} SurfacePencil;

// Pencils sorted into the cells of a grid over the scene; a pencil is in every cell that its radius reaches. A cell is a run of blocks of
// PENCIL_WIDTH entries, fields one after the other; the last block is filled with entries of radius 0.
typedef struct PencilGrid {
    float4 low;  // xyz: lowest corner; w: 1 / size of a cell [1 / scene units]
    int size_x;  // cells along each axis
    int size_y;
    int size_z;
    int unused;
    //------------------------------------------------- 32 B
} PencilGrid;

#define ENTRY_X 0  // position [scene units]
#define ENTRY_Y 1
#define ENTRY_Z 2
#define ENTRY_RADIUS 3
#define ENTRY_NX 4  // normal
#define ENTRY_NY 5
#define ENTRY_NZ 6
#define ENTRY_PENCIL 7  // index as int bits
#define ENTRY_FIELDS 8

PENCIL_SHARED_END
