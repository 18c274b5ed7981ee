// Hierarchical iteration (thesis ch. 7): levels of pencils, each the leaders of groups of the one before.
#pragma once

#include <vector>

#include "film/bounce_series.h"
#include "film/render_context.h"
#include "line/pencil_solver.h"

namespace pencil {

/// Light of all orders in one set: iterated to the end on the coarsest level; each finer one receives the light of the next coarser after one
/// more reflection, and direct light of its own. n pencils so cost n^2 / 2 or less, not k n^2 for k bounces, and early orders, which vary the most in
/// space, are carried by the finest levels.
/// DEVIATION: the thesis iterates small groups first, each by itself. Members of a group see what they reflect through a narrow bundle of
/// lines, so the light of a group alone is wrong (docs/accuracy.md); leaders are spread over the whole scene.
class LevelSolver {
public:
    /// `samples`: light samples light the scene, too, not emission of maps alone. `orders`: reflections that the maps may carry, emission is 0;
    /// below 0 until the tolerance.
    LevelSolver(RenderContext& context, PencilSolver& solver, bool samples, int orders)
        : context_(context), solver_(solver), samples_(samples), orders_(orders) {}

    PencilSet solve();
    /// Of the coarsest level.
    const BounceSeries& series() const { return series_; }

private:
    void make_levels();
    PencilSet iterate(PencilSet term, int first, int last);
    bool wanted(int order) const { return orders_ < 0 || order <= orders_; }

    RenderContext& context_;
    PencilSolver& solver_;
    bool samples_;
    int orders_;
    std::vector<PencilSet> levels_;  // finest first
    BounceSeries series_;
};

}  // namespace pencil
