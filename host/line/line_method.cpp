#include "line/line_method.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "certify/error_check.h"
#include "device/radiance_atlas.h"
#include "line/level_solver.h"
#include "line/planned_maps.h"
#include "line/project_pencils.h"
#include "line/series_end.h"
#include "line/sum_radiance.h"
#include "line/thin_film.h"
#include "line/weights.h"
#include "util/error.h"

namespace pencil {

namespace {

/// Surfels that no pencil sees are worth a warning above this share.
constexpr std::size_t blind_share = 100;

std::vector<SureKernel> sure_kernels(int form) {
    std::vector<SureKernel> sure{{"fold_hits", texels_of_set},
                                 {"find_enclosing"},
                                 {"find_sides"},
                                 {"gather_surfels", texels_of_set},
                                 {"store_radiance", texels_of_set},
                                 {"smooth_radiance", texels_of_set},
                                 {"sum_radiance"}};
    if (!weights_are_cells(form)) sure.push_back({"project_pencils"});  // those launch groups of their own
    if (weights_need_rays(form)) sure.push_back({"project_rays"});
    if (weights_in_maps(form) && weights_need_masks(form)) sure.insert(sure.end(), {{"test_visibility"}, {"estimate_density"}});
    if (weights_in_maps(form) && !weights_need_masks(form)) sure.push_back({"free_path_density", texels_of_set});
    return sure;
}

/// Directions that a surfel of the film may have at most.
int sites_of_cells(const RenderOptions& options) {
    return options.pencils + (weights_need_rays(kernel_weights(options)) ? film_rays(options, 0).count() : 0);
}

std::string explain_maps(const Kernels& kernels, const RenderOptions& options) {
    std::string text = "pencils: " + describe(kernels.map_shape(options.map));
    if (options.radiance_map > 0) text += "; light by " + describe(kernels.map_shape(options.radiance_map));
    if (options.density_map > 0 && weights_in_maps(kernels.features().weights))
        text += "; densities by " + describe(kernels.map_shape(options.density_map));
    return text;
}

std::string explain_iteration(const RenderOptions& options) {
    switch (options.iterate) {
        case Iterate::sets:
            return "iteration: a new, smaller set for each bounce";
        case Iterate::fixed:
            return "iteration: one fixed set; its geometry maps and weights are made once";
        case Iterate::levels:
            break;
    }
    return fmt::format("iteration: levels of {} pencils; the last carries all late bounces", fmt::join(level_sizes(options.pencils), ", "));
}

}  // namespace

MethodNeeds line_needs(const Scene& scene, const std::vector<LightForm>& forms, const RenderOptions& options) {
    const int form = kernel_weights(options);
    if (weights_need_even_centres(form) && !fills_box_evenly(options.placement))
        throw UsageError(weights_need_rays(form)
                             ? "--method hybrid holds for centres spread evenly; take --placement random or lds, or --method line"
                             : "--weights analytic holds for centres spread evenly; take --placement random or lds, or --weights dpdf or "
                               "voronoi");
    const int kind = kernel_map_kind(options.map_kind);
    if (kind != PENCIL_MAP_OCTAHEDRAL && (options.field || options.keep_field))
        throw UsageError("a field of pencils has octahedral maps; take --map-kind octahedral");
    if (scene.environment || !scene.directional_lights.empty())
        throw UsageError(options.keep_field ? "a field needs lights at a finite distance: no environment, sky or directional light"
                                            : "line projection knows no light from infinitely far away: environments, skies, directional "
                                              "lights; take --method surface");
    if (scene.sensor.orthographic || scene.sensor.aperture_radius > 0)
        throw UsageError(options.keep_field ? "a field is baked from a pinhole camera's scene; take a perspective sensor"
                                            : "line projection knows the pinhole camera alone; take --method surface");
    MethodNeeds needs;
    if (!options.field && options.bounces != 0) needs.kernels = sure_kernels(form);
    const bool checked = LineCheck::wanted(options, maps_carry_emitters(scene, forms));
    if (checked) needs.kernels.push_back({"trace_checks"});
    needs.maps = planned_maps(scene, forms, options);
    needs.hierarchy = follows_rays(options.placement) || weights_need_rays(form) || shows_part(options) || checked;
    needs.map_kind = kind;
    needs.atlas = options.bounces != 0;
    needs.weights = form;
    needs.cell_grid = weights_are_cells(form) ? largest_cell_grid(sites_of_cells(options)) : 0;
    return needs;
}

/// thesis alg. 6.4, or eq. (6.1) for one fixed set. The maps of step k hold the radiance of bounce order k and make layer k + 1.
bool LineMethod::advance() {
    if (!frame_) return begin();
    if (context_.options.field) {
        show_field();
        return false;
    }
    if (context_.options.iterate == Iterate::levels) {
        show_levels();
        check();
        return false;
    }
    if (projected_ == 0) {
        find_rooms();
        make_solver();
        make_first_set();
    } else {
        // Emitters of the other form join the maps after one bounce: from there on both carry order 1.
        set_ = next_set(order_ == 0 && frame_->lights().maps.count > 0);
        ++order_;
    }
    project();
    if (context_.wanted(order_ + 2) && !series_ended(series_, context_.options.tolerance, context_.stats)) return true;
    close_series();
    check();
    return false;
}

/// A field made elsewhere instead of sets: one projection-scatter of the light of all orders (thesis ch. 7, "fields made by another renderer").
void LineMethod::show_field() {
    const PencilField& field = *context_.options.field;
    if (context_.options.bounces != scene_bounces(context_.scene))
        context_.stats.warnings.push_back(
            fmt::format("the scene's max_depth of {} does not count: the light of the --field is of {}", context_.scene.max_depth,
                        field.orders < 0 ? "all orders of reflection" : fmt::format("up to {} reflections", field.orders)));
    free_space_ = std::make_unique<FreeSpace>(context_.device_scene, context_.flat, field.free_share);
    make_solver();
    field_view_ = std::make_unique<FieldView>(context_, *solver_, *free_space_);
    field_view_->show(frame_->film().surfels(), set_);
    show_set();
}

/// All orders of light in one set.
void LineMethod::show_set() {
    const double seconds = project_set();
    frame_->finish_bounce(FilmLayers::indirect, set_.maps->count, seconds);
}

/// Light that a field has brought does not depend on who looks.
void LineMethod::look() {
    frame_->look(Turn{context_.options.seed, 0, true});
    visible_ = visible_buffer();
    field_view_->show(frame_->film().surfels(), set_);
    project_set();
    frame_->finish_look();
}

/// What emitters send to the pencils of a set.
PencilSet LineMethod::emission_of(const PencilSet& set) {
    PencilSet emission(context_.kernels.device(), set.maps);
    solver_->fill(emission, nullptr, true, false, false);
    return emission;
}

/// The light of all orders in one set, by hierarchical iteration.
void LineMethod::show_levels() {
    find_rooms();
    make_solver();
    LevelSolver levels(context_, *solver_, frame_->lights().maps.count > 0,
                       context_.options.bounces < 0 ? -1 : context_.options.bounces - 1);
    set_ = levels.solve();
    if (context_.options.keep_field) {
        field_sum_ = std::make_unique<FieldSum>(set_, context_.flat, free_space_->share());
        field_sum_->add(set_, glm::dvec3(1.0));
        if (context_.maps_emit) field_sum_->add(emission_of(set_), glm::dvec3(-1.0));
    }
    series_ = levels.series();
    show_set();
    if (context_.options.bounces >= 0 || series_.steps() <= 1) return;
    context_.stats.tail_closed = !series_.diverges();
    context_.stats.residual = series_.tail_share();
}

/// Film and direct light.
bool LineMethod::begin() {
    const RenderOptions& options = context_.options;
    frame_ =
        std::make_unique<Frame>(context_, options.aovs, options.light_samples, light_map_size(options.map), Turn{options.seed, 0, true});
    order_ = context_.maps_emit ? 0 : 1;
    if (LineCheck::wanted(options, context_.maps_emit)) check_.begin(*frame_);
    return frame_->add_direct() && (options.field || context_.wanted(order_ + 1));
}

void LineMethod::find_rooms() {
    const LightSet& lights = frame_->lights();
    context_.clock.run("rooms", [&] {
        free_space_ = std::make_unique<FreeSpace>(context_.kernels, context_.device_scene, context_.flat, frame_->film().surfels(),
                                                  lights.maps.count > 0 ? &lights.maps : nullptr, context_.options.map);
    });
}

Buffer<int> LineMethod::visible_buffer() const {
    return {context_.kernels.device(), static_cast<std::size_t>(frame_->film().surfels().capacity), "visible pencils"};
}

void LineMethod::make_solver() {
    visible_ = visible_buffer();
    context_.clock.run("pencil maps", [&] {
        candidates_ = make_candidate_source({context_.kernels, context_.device_scene, context_.scene, context_.flat, context_.options.seed},
                                            context_.options.placement);
    });
    solver_ = std::make_unique<PencilSolver>(context_.kernels, context_.device_scene, *free_space_, *candidates_, frame_->lights(),
                                             context_.options, context_.clock);
}

void LineMethod::make_first_set() {
    const bool emission = context_.maps_emit;
    set_ = solver_->create(0, nullptr, emission, !emission);
    solver_->fill(set_, nullptr, emission, !emission, true);
}

/// The set that carries the next bounce order: new pencils, or the same ones with new radiance.
PencilSet LineMethod::next_set(bool direct) {
    if (context_.options.iterate == Iterate::fixed) return solver_->reflect(set_, direct);
    PencilSet next = solver_->create(projected_, &set_, false, direct);
    solver_->fill(next, &set_, false, direct, true);
    return next;
}

/// Adds the bounce that the set carries to the film.
void LineMethod::project() {
    series_.add(sum_radiance(context_.kernels, set_));
    if (context_.options.keep_field) {
        if (!field_sum_) field_sum_ = std::make_unique<FieldSum>(set_, context_.flat, free_space_->share());
        if (order_ > 0) field_sum_->add(set_, glm::dvec3(1.0));
    }
    const double seconds = project_set();
    frame_->finish_bounce(order_ + 1, set_.maps->count, seconds);
    context_.clock.set_fraction(progress());
}

/// Adds what the surfels of the film reflect of the set's light; takes so many seconds.
double LineMethod::project_set() {
    int surfels = frame_->film().surfels().count;
    const double seconds = context_.clock.run("projection-scatter", [&] {
        const RayChoice rays = film_rays(context_.options, context_.options.field ? 0 : projected_);
        const std::string what = "projection-scatter";
        if (!context_.options.thin) return solver_->project(frame_->film().surfels(), set_, rays, frame_->outgoing(), visible_, what);
        const ThinFilm thin(context_.kernels, frame_->film());
        surfels = thin.surfels().count;
        Buffer<float> light = surfel_rgb(context_.kernels.device(), thin.surfels().capacity, "light of picked surfels");
        solver_->project(thin.surfels(), set_, rays, light, visible_, what);
        thin.spread(context_.kernels, light, frame_->outgoing());
    });
    if (projected_++ == 0 && !context_.options.thin) count_blind(surfels);
    return seconds;
}

/// Fraction of the work done, from how far the last bounce has fallen towards the tolerance on a logarithmic scale.
double LineMethod::progress() const {
    const RenderOptions& options = context_.options;
    if (options.bounces > 0) return static_cast<double>(context_.stats.bounces.size()) / options.bounces;
    const double share = std::max(series_.last_share(), options.tolerance);
    return std::clamp(std::log(share) / std::log(std::min(options.tolerance, 0.5)), 0.0, 1.0);
}

void LineMethod::count_blind(int surfels) {
    RenderStats& stats = context_.stats;
    const std::vector<int> visible = visible_.read(0, static_cast<std::size_t>(surfels));
    stats.blind_surfels = static_cast<std::uint64_t>(std::count(visible.begin(), visible.end(), 0));
    if (weights_need_rays(context_.kernels.features().weights)) return;  // the others have their rays
    if (stats.blind_surfels > visible.size() / blind_share)
        stats.warnings.push_back(fmt::format("{} of {} film surfels are seen by no pencil and get no indirect light; use more --pencils",
                                             stats.blind_surfels, visible.size()));
}

/// An endless series gets its geometric tail.
void LineMethod::close_series() {
    if (context_.options.bounces >= 0 || series_.steps() <= 1) return;
    if (series_.diverges()) {
        context_.stats.residual = std::numeric_limits<double>::infinity();
        return;
    }
    if (field_sum_) field_sum_->add(set_, series_.tail_factor());
    context_.stats.tail_closed = true;
    context_.stats.residual = frame_->layers().close_series(series_.tail_factor());
}

void LineMethod::check() {
    if (LineCheck::wanted(context_.options, context_.maps_emit)) check_.end(context_, *frame_, series_);
}

double LineMethod::estimated_error() const { return join_errors(std::numeric_limits<double>::infinity(), check_.found()); }

std::vector<Layer> LineMethod::snapshot() const { return frame_ ? frame_->snapshot() : std::vector<Layer>(); }
std::vector<Layer> LineMethod::take() { return frame_ ? frame_->take_layers() : std::vector<Layer>(); }

std::shared_ptr<PencilField> LineMethod::field() const {
    if (!field_sum_) return nullptr;
    auto field = std::make_shared<PencilField>(field_sum_->field());
    if (context_.options.bounces >= 0) field->orders = context_.options.bounces - 1;  // the film makes the last
    return field;
}

std::vector<std::string> LineMethod::explain() const {
    const RenderOptions& options = context_.options;
    std::vector<std::string> lines{explain_maps(context_.kernels, options),
                                   explain_weights(context_.kernels.features().weights, cell_grid(sites_of_cells(options))),
                                   explain_iteration(options), explain_atlas(context_.kernels.features())};
    if (options.bounces == 1) lines.push_back("left out: all pencil sets that do not carry direct light (one reflection)");
    if (options.field)
        return {lines[0], lines[1],
                fmt::format("left out: rooms, placement and transport between pencils; the light is that of a field of {}{}",
                            options.field->count(), shows_part(options) ? fmt::format(", of which a view uses {}", options.pencils) : "")};
    if (!check_.left_out().empty()) lines.push_back(check_.left_out());
    if (projected_ == 0) return lines;
    std::string rooms;
    for (int shape : free_space_->rooms()) rooms += (rooms.empty() ? "" : ", ") + context_.scene.shapes[static_cast<std::size_t>(shape)].id;
    lines.push_back(
        fmt::format("placement: {}; rejected {} centres inside solids and {} that see no surface which film, lights or others see{}",
                    candidates_->describe(), free_space_->in_solids(), free_space_->unreached(),
                    (rooms.empty() ? std::string() : "; rooms, because the camera or a light is inside: " + rooms)));
    return lines;
}

}  // namespace pencil
