#include "surface/field_method.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pencils/light_samples.h"
#include "pencils/low_discrepancy.h"
#include "surface/trace_field.h"

namespace pencil {

namespace {

/// Texels that are worked on at once: bounds memory and the length of a launch.
constexpr int chunk_texels = 1 << 18;
/// Pencils of the field that look for surfaces which reflect light, at most.
constexpr std::size_t most_lookers = 512;
/// Pencils of the world set, light samples that 16 texels draw, and rays of the world set for each one of the field: found by trial on the Cornell
/// box (docs/accuracy.md).
constexpr int world_pencils = 3200, light_draws = 8;
constexpr double world_share = 0.3;
/// Width of the maps of the world set.
constexpr int least_world_map = 8, most_world_map = 32;

SurfacePass field_pass(const RenderOptions& options, const Camera& film) {
    SurfacePass pass = surface_pass(0, options, film, 1);
    pass.world.pencils = world_pencils;
    pass.world.light_draws = light_draws;
    pass.draws_lights = true;
    return pass;
}

/// Pencils in free space at these places, with maps of `map` x `map` texels: one for each of `sides` looks along z or, -1, against it; 0: all around.
SurfacePencils pencils_at(const std::shared_ptr<Device>& device, const std::vector<glm::vec3>& places, const std::vector<float>& sides,
                          int map) {
    std::vector<SurfacePencil> made;
    for (const glm::vec3& place : places)
        for (const float side : sides) {
            SurfacePencil pencil{};
            pencil.position = float4(place, 0.0F);
            pencil.normal = pencil.facing = {0, 0, side, 0};
            pencil.plane = -1;
            pencil.key = static_cast<uint>(made.size());
            made.push_back(pencil);
        }
    return {device, made, map};
}

}  // namespace

FieldMethod::FieldMethod(RenderContext& context)
    : context_(context), target_(*context.options.field), pass_(field_pass(context.options, context.flat.camera)) {
    for (const glm::dvec3& centre : target_.centres) centres_.emplace_back(context.flat.normalisation.to_scene(centre));
    pencils_ = pencils_at(context.kernels.device(), centres_, {0.0F}, target_.map);
    sum_.assign(3 * static_cast<std::size_t>(target_.width()) * static_cast<std::size_t>(target_.height()), 0.0);
    context.clock.allow_stops();
}

bool FieldMethod::advance() {
    const RenderOptions& options = context_.options;
    const std::uint64_t seed = hash64(hash64(options.seed) + static_cast<std::uint64_t>(passes_) + 1);
    whole_ = false;
    make_solver(seed);
    const double rays = world_share * target_.count() * pencils_.texels() / std::max(solver_->world().count, 1);
    const int map = std::clamp(4 * static_cast<int>(std::lround(std::sqrt(rays) / 4)), least_world_map, most_world_map);
    solver_->solve(map, options.bounces, options.tolerance, seed);
    context_.stats.residual = solver_->residual();
    gather(seed);
    whole_ = true;
    ++passes_;
    context_.clock.set_fraction(static_cast<double>(passes_) / options.field_rays);
    return passes_ < options.field_rays;
}

/// Some of the pencils, each looking both ways.
SurfacePencils FieldMethod::seeds() const {
    const std::size_t count = std::min(centres_.size(), most_lookers);
    std::vector<glm::vec3> some;
    for (std::size_t k = 0; k < count; ++k) some.push_back(centres_[k * centres_.size() / count]);
    return pencils_at(context_.kernels.device(), some, {1.0F, -1.0F}, film_map);
}

/// A world set on what the pencils see, that knows what the last one has found.
void FieldMethod::make_solver(std::uint64_t seed) {
    const std::vector<LightSample> samples = sample_lights(context_.scene, context_.flat, context_.forms, pass_.light_samples, seed);
    const float spacing = solver_ ? solver_->spacing() : 0;
    const std::vector<Spot> spots = solver_ ? solver_->course().spots : std::vector<Spot>();
    solver_ = nullptr;  // its memory first
    solver_ = std::make_unique<SurfaceSolver>(context_.kernels, context_.device_scene,
                                              surface_lights(context_, context_.kernels.device(), pass_, samples, seed), pass_.world,
                                              context_.clock, static_cast<uint>(seed >> 32), context_.helpers);
    solver_->know(spots);
    solver_->place(seeds(), spacing);
    context_.stats.world_pencils += static_cast<std::uint64_t>(solver_->world().count);
}

/// A ray of each texel.
void FieldMethod::gather(std::uint64_t seed) {
    const int texels = pencils_.texels(), chunk = std::clamp(chunk_texels / texels, 1, target_.count());
    const TexelPoints points{static_cast<uint>(hash64(context_.options.seed) >> 32), static_cast<uint>(passes_)};
    Surfels seen(context_.kernels, chunk * texels, "surfels of the field");
    Buffer<float> radiance = surfel_rgb(context_.kernels.device(), seen.capacity, "radiance of the field");
    for (int first = 0; first < target_.count(); first += chunk)
        context_.clock.run("field", [&] {
            const int count = std::min(chunk, target_.count() - first);
            trace_field(context_.kernels, context_.device_scene, pencils_, first, count, points, seen);
            radiance.fill_zero();
            solver_->light_field(seen, {pencils_, first}, seed, radiance);
            add(first, count, seen, radiance);
        });
}

/// Adds radiance on the device to the sums of pencils first .. first + count.
void FieldMethod::add(int first, int count, const Surfels& seen, const Buffer<float>& radiance) {
    const int texels = pencils_.texels();
    const auto all = static_cast<std::size_t>(count) * static_cast<std::size_t>(texels);
    const std::vector<float> rgb = radiance.read_rows(0, static_cast<std::size_t>(seen.capacity), 3, all);
    for (int p = 0; p < count; ++p)
        for (int i = 0; i < texels; ++i) {
            const glm::ivec2 texel = field_texel(i, target_.map);
            const std::size_t to = target_.index(first + p, texel.x, texel.y),
                              from = static_cast<std::size_t>(p) * static_cast<std::size_t>(texels) + static_cast<std::size_t>(i);
            for (std::size_t c = 0; c < 3; ++c) sum_[to + c] += static_cast<double>(rgb[c * all + from]);
        }
}

std::shared_ptr<PencilField> FieldMethod::field() const {
    if (!whole_) return nullptr;
    auto field = std::make_shared<PencilField>(target_);
    const double unit = context_.flat.normalisation.light / passes_, most = std::numeric_limits<float>::max();
    field->light.clear();
    field->light.reserve(sum_.size());
    for (const double value : sum_) field->light.push_back(static_cast<float>(std::clamp(value * unit, 0.0, most)));
    return field;
}

std::vector<std::string> FieldMethod::explain() const {
    return {fmt::format(
        "light of {} pencils with maps of {} x {} texels: {} passes, each with a ray of every texel and a world set of about {} pencils",
        target_.count(), target_.map, target_.map, context_.options.field_rays, pass_.world.pencils)};
}

}  // namespace pencil
