// `pencil bake`: the light of a scene in the maps of one set of pencils, by another method or the path tracer, for `render --field`.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/message.h"
#include "app/outputs.h"
#include "field/field_file.h"
#include "reference/path_tracer.h"
#include "render/render.h"
#include "scene/formats/load_scene.h"
#include "util/error.h"
#include "util/format.h"
#include "util/log.h"
#include "util/progress.h"
#include "util/stopwatch.h"

namespace pencil {
namespace {

/// Width of the image that finds the rooms which the camera sees.
constexpr int finder_width = 64;

/// Reflections that the light of the scene's field makes at most: a film that shows it makes one more.
int field_orders(const Scene& scene, const std::filesystem::path& path) {
    if (scene.max_depth < 0) return endless_orders;
    const int orders = scene.max_depth - 2;
    if (orders < 1)
        throw SceneError(path.string(), fmt::format("its max_depth of {} leaves no light that one surface sends to another: there is "
                                                    "nothing to bake; 3 is the least, -1 no limit",
                                                    scene.max_depth));
    return orders;
}

/// MemoryError if a field of this size cannot be made here, UsageError if it could not be read again.
void check_field(int pencils, int map) {
    check_field_size(pencils, map);
    constexpr std::uint64_t texel_bytes = 56;  // sums in double precision, counts, and the image twice
    const std::uint64_t needed = field_bytes(pencils, map) / (3 * sizeof(float)) * texel_bytes, present = machine_memory();
    if (needed > present)
        throw MemoryError(
            fmt::format("to make a field of {} pencils with maps of {} x {} texels takes {}, this machine has {}; try fewer "
                        "--pencils or a smaller --map",
                        pencils, map, map, format_size(needed), format_size(present)));
}

/// Whether the light is made for given centres, by another method than the one that places them.
bool fills_centres(BakeFrom from) { return from == BakeFrom::reference || from == BakeFrom::surface; }

RenderOptions bake_options(const BakeCommand& command, const Scene& scene) {
    RenderOptions options = command.options;
    options.method = command.from == BakeFrom::line ? MethodName::line : MethodName::hybrid;
    options.iterate = Iterate::levels;
    options.keep_field = true;
    options.width = finder_width;
    options.height = std::max(finder_width * scene.sensor.height / std::max(scene.sensor.width, 1), 1);
    options.aovs = {};
    if (fills_centres(command.from)) options.bounces = 2;  // its centres alone count
    return options;
}

/// Rays of a texel.
int field_rays(const BakeCommand& command) {
    if (command.spp > 0) return command.spp;
    return command.from == BakeFrom::surface ? standard_field_rays : standard_field_paths;
}

/// Reflected light along the rays of the pencils; false if it was interrupted before every texel had a path.
bool trace_light(const Scene& scene, const BakeCommand& command, const ReferenceProgress& progress, PencilField& field) {
    field.light = {};  // the pencils alone are asked for
    ReferenceOptions options;
    options.spp = field_rays(command);
    options.field = std::make_shared<PencilField>(field);
    options.max_depth = field.orders < 0 ? -1 : field.orders + 1;
    options.seed = command.options.seed;
    ReferenceResult result = trace_paths(scene, options, progress);
    for (const std::string& warning : result.warnings) print_warning(warning);
    field.light = std::move(result.layers.front().pixels);
    return result.spp > 0;
}

/// The same by surface pencils.
bool gather_light(const Scene& scene, const BakeCommand& command, const std::shared_ptr<Device>& device, const Progress& progress,
                  PencilField& field) {
    field.light = {};
    RenderOptions options = command.options;
    options.method = MethodName::surface;
    options.pencils = pencils_of_method;
    options.field = std::make_shared<PencilField>(field);
    options.field_rays = field_rays(command);
    options.width = options.height = finder_width;  // of no image
    options.aovs = {};
    const RenderResult result = render(scene, options, device, progress);
    for (const std::string& warning : result.stats.warnings) print_warning(warning);
    if (!result.failure.empty() && interrupted_by() == 0) throw DeviceError(result.failure);
    if (result.field) field.light = result.field->light;
    return result.field && !result.interrupted;
}

}  // namespace

ExitCode run_bake(const BakeCommand& command) {
    const Stopwatch total;
    set_quiet(command.quiet);
    check_outputs({command.output}, {}, command.scene);
    if (image_format(command.output) != ImageFormat::exr) throw UsageError("--output: a field is an OpenEXR file, .exr");
    check_field(command.options.pencils, command.options.map);
    const Scene scene = load_scene(command.scene, command.load);
    for (const std::string& warning : scene.warnings) print_warning(warning);
    const int orders = field_orders(scene, command.scene);
    ProgressDisplay display(command.quiet ? ProgressDisplay::Style::none : ProgressDisplay::style_for(stderr));
    const auto progress = [&display](const std::string& stage, double fraction) {
        display.update(stage, fraction);
        return interrupted_by() == 0;
    };
    const std::shared_ptr<Device> device = Device::open(command.device);
    RenderResult result = render(scene, bake_options(command, scene), device, progress);
    for (const std::string& warning : result.stats.warnings) print_warning(warning);
    if (!result.failure.empty() && interrupted_by() == 0) throw DeviceError(result.failure);
    bool whole = result.field && !result.interrupted;
    if (result.field) result.field->orders = orders;
    if (whole && command.from == BakeFrom::reference) whole = trace_light(scene, command, progress, *result.field);
    if (whole && command.from == BakeFrom::surface) whole = gather_light(scene, command, device, progress, *result.field);
    if (!whole && interrupted_by() != 0) {
        print_error("interrupted before the field was whole; nothing is written");
        return ExitCode::interrupted;
    }
    if (!whole) throw SceneError(command.scene.string(), "no light reaches a surface: there is nothing to bake");
    write_field(command.output, *result.field, to_string(command.from));
    if (!command.quiet)
        std::cout << fmt::format("wrote {}: {} pencils with maps of {} x {} texels by {}, {:.1f} s\n", command.output.string(),
                                 result.field->count(), result.field->map, result.field->map, to_string(command.from), total.seconds());
    return interrupted_by() == 0 ? ExitCode::ok : ExitCode::interrupted;
}

}  // namespace pencil
