// Texels that see something from so near that the world set is too coarse there: in creases, under things, where walls meet. What the world
// set is wrong by between its pencils is seen large there, is the same in many pencils and never averages out. One texel of each block of
// such texels gathers for all of them: noise instead of error, and noise is known.
#pragma once

#include "surface/place_surface_pencils.h"
#include "surface/trace_hemispheres.h"

namespace pencil {

struct Contacts {
    ChosenSurfels chosen;       // one of each block that has contacts
    std::vector<float> counts;  // contacts of the block: it stands for all of them
};

/// Blocks are packets of `contact_block` texels. `contact`: 1 for each texel that is one, `texels` for each of the pencils that see them.
/// Each is as likely as the others of its block, so that sums over texels stay right in the mean.
Contacts choose_contacts(const std::vector<unsigned char>& contact, const std::vector<SurfacePencil>& pencils, int texels,
                         const TexelPoints& points);

/// Texels of a block, and width of the maps of pencils at contacts: as many rays as texels.
constexpr int contact_block = 16, contact_map = 4;

}  // namespace pencil
