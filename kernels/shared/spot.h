// Bright spots: places that reflect much of the light or that it comes through, as spheres: centre [scene units], w: radius.
#pragma once

#include "shared/types.h"

#define SPOTS_MOST 16
// Rays of a pencil towards them, a multiple of every packet's width.
#define SPOT_RAYS 16
