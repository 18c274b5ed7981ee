// A pencil on a surface: the hemisphere seen from a surfel, and how far its irradiance may be reused. The irradiance itself is in a buffer
// beside the pencils: irradiance[pencil], rgb [W m^-2], w 0.
#pragma once

#include "shared/types.h"

#define RING_SECTORS 8       // of azimuth about the normal
#define LINK_STANDS_IN (-2)  // second link of a surfel whose first pencil stands for it only because no other does

PENCIL_SHARED_BEGIN

typedef struct SurfacePencil {
    float4 position;  // xyz [scene units]; w: harmonic mean of the distances seen [scene units], INFINITY if nothing is
    float4 normal;    // xyz: unit shading normal of the seen side; w: radius within which it may be used [scene units]
    float4 facing;    // xyz: unit geometric normal of that side; w: of film pencils, position.w or the distance of emitters
    //------------------------------------------------- 48 B
    // What stands at the horizon of each sector, the nearest plane and then the next: points p of the tangent plane with
    // p.x horizon_x + p.y horizon_y >= 1 are behind it; 0 if there is none [1 / scene units]
    float horizon_x[2 * RING_SECTORS];
    float horizon_y[2 * RING_SECTORS];
    //------------------------------------------------- 176 B
    int plane;       // of the surface that it lies on: index into planes
    uint key;        // decides where in its texels the points lie that it sees
    int spacing;     // at which it joined the lattice of film pencils [pixels]; 0 if it lies on none
    float emitters;  // harmonic mean distance of the emitters seen whose light pencils carry [scene units], INFINITY if none is
    //------------------------------------------------- 192 B
} SurfacePencil;
PENCIL_SHARED_TYPE(SurfacePencil)

// Pencils by place, in levels of cells, each PENCIL_GRID_STEP times as wide as those of the level below. A pencil is on the lowest level on
// which its radius is at most PENCIL_GRID_REACH cells, in every cell that it reaches, so pencils of all sizes are found in few cells. Cells are
// hashed into the slots of their level. A slot is a run of blocks of PENCIL_WIDTH entries, fields one after the other; the last block is filled with
// entries of radius 0.
typedef struct PencilGrid {
    float4 origin;  // xyz: a corner of level 0 [scene units]; w: 1 / width of the cells of level 0 [1 / scene units]
    int levels;
    int slots;  // of each level, a power of two
    int count;  // of all pencils
    int unused;
    //------------------------------------------------- 32 B
} PencilGrid;
PENCIL_SHARED_TYPE(PencilGrid)

// A radius reaches at most so many cells of its level.
#define PENCIL_GRID_REACH 1.0f
// Larger steps look into fewer cells, smaller ones find fewer pencils in them that do not reach: found by trial.
#define PENCIL_GRID_STEP 4.0f

// Where no cell about a point has a pencil to stand for it, so many are looked at, this many apart (a prime, so that no two are the same).
#define PENCIL_GRID_LOOK 256u
#define PENCIL_GRID_STRIDE 7919u

// Slot of a cell; cells that share one only cost time.
#define PENCIL_GRID_SLOT(x, y, z, level, slots) \
    ((int)(PENCIL_GRID_MIX((uint)(x)*0x9e3779b1u ^ (uint)(y)*0x85ebca77u ^ (uint)(z)*0xc2b2ae3du) & (uint)((slots)-1)) + (level) * (slots))
#define PENCIL_GRID_MIX(h) ((h) ^ ((h) >> 15) ^ ((h) >> 7))

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
