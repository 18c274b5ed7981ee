#include "line/level_solver.h"

#include "line/group_leaders.h"
#include "line/planned_maps.h"
#include "line/series_end.h"
#include "line/sum_radiance.h"

namespace pencil {

namespace {

/// Adds `factor` times the light of `term` to that of `sum`; launcher of add_radiance.cl.
void add_light(Kernels& kernels, const PencilSet& term, const glm::dvec3& factor, PencilSet& sum) {
    const int texels = static_cast<int>(term.radiance.size());
    kernels.get("add_radiance")
        .args(term.radiance, float4(glm::vec3(factor), 0.0F), texels, sum.radiance)
        .run(term.radiance.size(), "sum of bounces");
}

PencilSet copy_of(Kernels& kernels, const PencilSet& set) {
    PencilSet copy(kernels.device(), set.maps);
    copy.radiance.copy_from(set.radiance, 0, 0, set.radiance.size());
    return copy;
}

}  // namespace

PencilSet LevelSolver::solve() {
    make_levels();
    // Light of the level's first order starts there: where maps emit, light samples add theirs from order 1 on.
    const bool emission = context_.maps_emit;
    const int first = emission ? 0 : 1, coarsest = static_cast<int>(levels_.size()) - 1;
    PencilSet& start = levels_.back();
    solver_.fill(start, nullptr, emission, !emission, true);
    PencilSet light = iterate(std::move(start), first, orders_ < 0 ? -1 : orders_ - coarsest);
    for (int level = coarsest - 1; level >= 0; --level) {
        PencilSet& finer = levels_[static_cast<std::size_t>(level)];
        solver_.fill(finer, &light, emission, samples_, true);
        light = std::move(finer);
    }
    return light;
}

/// As many levels as there are orders to be carried by them.
void LevelSolver::make_levels() {
    const bool emission = context_.maps_emit;
    const int first = emission ? 0 : 1, levels = static_cast<int>(level_sizes(context_.options.pencils).size());
    levels_.push_back(solver_.create(0, nullptr, emission, !emission));
    for (int level = 1; level < levels && wanted(first + level); ++level)
        levels_.push_back(solver_.create_at(group_leaders(levels_.back().maps->cops.read(), level_group)));
}

/// All orders from `first` to `last` (below 0: until the tolerance) of a set that holds the first.
PencilSet LevelSolver::iterate(PencilSet term, int first, int last) {
    PencilSet sum = copy_of(context_.kernels, term);
    series_.add(sum_radiance(context_.kernels, term));
    for (int order = first; last < 0 || order < last; ++order) {
        const bool light_joins = samples_ && order == 0;  // after emission
        if (order > 0 && series_ended(series_, context_.options.tolerance, context_.stats)) break;
        term = solver_.reflect(term, light_joins);
        series_.add(sum_radiance(context_.kernels, term));
        add_light(context_.kernels, term, glm::dvec3(1.0), sum);
    }
    if (last < 0 && !series_.diverges()) add_light(context_.kernels, term, series_.tail_factor(), sum);
    return sum;
}

}  // namespace pencil
