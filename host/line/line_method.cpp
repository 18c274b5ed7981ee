#include "line/line_method.h"

#include <algorithm>
#include <cmath>

#include "film/bounce_series.h"
#include "line/pencil_solver.h"
#include "line/project_pencils.h"
#include "line/sum_radiance.h"

namespace pencil {

namespace {

/// Orders of bounces after which the series is closed by its tail whatever the tolerance.
constexpr int most_bounces = 512;

class LineMethod {
public:
    LineMethod(RenderContext& context, Frame& frame)
        : context_(context),
          frame_(frame),
          visible_(context.kernels.device(), static_cast<std::size_t>(frame.film().surfels().capacity), "visible pencils") {}

    void run() {
        bounce();
        if (context_.clock.stopped() || context_.options.bounces >= 0 || series_.steps() <= 1) return;
        context_.stats.tail_closed = true;
        context_.stats.residual = frame_.layers().close_series(series_.tail_factor());
    }

private:
    /// thesis alg. 6.4, or eq. (6.1) for one fixed set. The maps of step k hold the radiance of bounce order k and make layer k + 1.
    void bounce() {
        int order = context_.maps_emit ? 0 : 1;
        StageClock& clock = context_.clock;
        const LightSet& lights = frame_.lights();
        if (!context_.wanted(order + 1) || clock.stopped()) return;
        std::unique_ptr<FreeSpace> free_space;
        clock.run("rooms", [&] {
            free_space = std::make_unique<FreeSpace>(context_.kernels, context_.device_scene, context_.flat, frame_.film().surfels(),
                                                     lights.maps.count > 0 ? &lights.maps : nullptr, context_.options.map);
        });
        std::unique_ptr<CandidateSource> candidates;
        clock.run("pencil maps", [&] {
            candidates =
                make_candidate_source({context_.kernels, context_.device_scene, context_.scene, context_.flat, context_.options.seed},
                                      context_.options.placement);
        });
        PencilSolver solver(context_.kernels, context_.device_scene, *free_space, *candidates, lights, context_.options, clock);
        PencilSet set = solver.create(0, nullptr, context_.maps_emit, !context_.maps_emit);
        solver.fill(set, nullptr, context_.maps_emit, !context_.maps_emit, true);
        for (int index = 0;; ++index, ++order) {
            series_.add(sum_radiance(context_.kernels, set));
            const double seconds = clock.run("projection-scatter", [&] {
                project_pencils(context_.kernels, context_.device_scene, frame_.film().surfels(), set, solver.weight_tables(),
                                frame_.outgoing(), visible_, "projection-scatter");
            });
            if (index == 0) count_blind();
            frame_.finish_bounce(order + 1, set.maps->count, seconds);
            clock.set_fraction(progress());
            if (clock.stopped() || !context_.wanted(order + 2) || converged(index)) break;
            // Emitters of the other form join the maps after one bounce: from there on both carry order 1.
            set = next_set(solver, set, index + 1, order == 0 && lights.maps.count > 0);
        }
        explain_placement(*free_space, *candidates);
    }

    /// The set that carries the next bounce order: new pencils, or the same ones with new radiance.
    PencilSet next_set(PencilSolver& solver, const PencilSet& set, int index, bool direct) {
        const bool fixed = context_.options.iterate == Iterate::fixed;
        PencilSet next = fixed ? PencilSet(context_.kernels.device(), set.maps) : solver.create(index, &set, false, direct);
        if (fixed && weights_in_maps(context_.options.weights))
            next.radiance.copy_from(set.radiance, 0, 0, set.radiance.size());  // the quadrature weights stay, the radiance is overwritten
        solver.fill(next, &set, false, direct, !fixed);
        return next;
    }

    /// Stops the series by tolerance; warns and stops a series that does not decrease.
    bool converged(int steps) {
        if (series_.last_share() < context_.options.tolerance) return true;
        if (steps < most_bounces) return false;
        context_.stats.warnings.push_back("bounces do not decrease (albedo near 1 in a closed scene): stopped after " +
                                          std::to_string(most_bounces) + ", not converged");
        return true;
    }

    /// Fraction of the work done, from how far the last bounce has fallen towards the tolerance on a logarithmic scale.
    double progress() const {
        const RenderOptions& options = context_.options;
        if (options.bounces > 0) return static_cast<double>(context_.stats.bounces.size()) / options.bounces;
        const double share = std::max(series_.last_share(), options.tolerance);
        return std::clamp(std::log(share) / std::log(std::min(options.tolerance, 0.5)), 0.0, 1.0);
    }

    void count_blind() {
        RenderStats& stats = context_.stats;
        const std::vector<int> visible = visible_.read(0, static_cast<std::size_t>(frame_.film().surfels().count));
        stats.blind_surfels = static_cast<std::uint64_t>(std::count(visible.begin(), visible.end(), 0));
        if (stats.blind_surfels > visible.size() / 100)
            stats.warnings.push_back(std::to_string(stats.blind_surfels) + " of " + std::to_string(visible.size()) +
                                     " film surfels are seen by no pencil and get no indirect light; use more --pencils");
    }

    void explain_placement(const FreeSpace& free_space, const CandidateSource& candidates) {
        std::string rooms;
        for (int shape : free_space.rooms())
            rooms += (rooms.empty() ? "" : ", ") + context_.scene.shapes[static_cast<std::size_t>(shape)].id;
        context_.stats.explain.push_back("placement: " + candidates.describe() + "; rejected " + std::to_string(free_space.in_solids()) +
                                         " centres inside solids and " + std::to_string(free_space.unreached()) +
                                         " that see no surface which film, lights or others see" +
                                         (rooms.empty() ? std::string() : "; rooms, because the camera or a light is inside: " + rooms));
    }

    RenderContext& context_;
    Frame& frame_;
    Buffer<int> visible_;
    BounceSeries series_;
};

}  // namespace

void add_line_bounces(RenderContext& context, Frame& frame) { LineMethod(context, frame).run(); }

}  // namespace pencil
