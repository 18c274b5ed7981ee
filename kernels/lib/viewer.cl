// Numbers of surfels for random choices: the same however the pencils that see them are divided among launches and devices.

#include "lib/hash.cl"
#include "shared/surface_pencil.h"

/// Number of surfel i, one of the `texels` that viewers[first_viewer + i / texels] sees; its own where texels is 0: nobody does.
static inline uint seen_number(global const SurfacePencil *viewers, int first_viewer, int texels, int i) {
    return texels > 0 ? hash_uint(viewers[first_viewer + i / texels].key) + (uint)(i % texels) : (uint)i;
}
