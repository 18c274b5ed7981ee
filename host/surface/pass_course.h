// Where the passes of a render stand: what the next one needs of those before, beside the sums.
#pragma once

#include <vector>

#include "options/render_result.h"
#include "surface/surface_solver.h"
#include "surface/world_balance.h"
#include "util/archive.h"

namespace pencil {

/// Halvings of the world set where memory is short.
constexpr int most_thrift = 4;

struct PassCourse {
    int index = 0;                            // of the next pass
    double film_rays = 0;                     // of film pencils of the last one
    int world_set = -1;                       // that was placed last,
    int placed_by = 0;                        // by this pass,
    int wish = 1;                             // with so many pencils in mind
    float guess = 0;                          // and this guess of their spacing,
    float spacing = 0;                        // which became this
    int thrift = 0;                           // times that memory was short: each halves what the world set takes
    double work = 0;                          // of all, as Patience counts it
    std::vector<unsigned char> placed_split;  // pixels that were split (Film) in the pass that placed the world set; empty: none
    std::vector<uint> missed, missed_before;  // pixels that see what no pencil stood for, and those known when the world set was placed
    double pixel_noise = 0, mean_noise = 0;   // of a pass, when the world set was placed
    WorldBalance balance;
    SurfaceSolver::Course solver;

    /// ArchiveError for what no render leaves behind.
    void transfer(Archive& archive);
    /// ArchiveError unless it is of an image of so many pixels.
    void expect_pixels(std::size_t pixels) const;
};

/// The part of the stats that passes add to.
void transfer_stats(RenderStats& stats, Archive& archive);

}  // namespace pencil
