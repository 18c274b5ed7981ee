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
#include "util/log.h"
#include "util/progress.h"
#include "util/stopwatch.h"

namespace pencil {
namespace {

/// Width of the image that finds the rooms which the camera sees.
constexpr int finder_width = 64;

RenderOptions bake_options(const BakeCommand& command, const Scene& scene) {
    RenderOptions options = command.options;
    options.method = command.from == BakeFrom::line ? MethodName::line : MethodName::hybrid;
    options.iterate = Iterate::levels;
    options.keep_field = true;
    options.width = finder_width;
    options.height = std::max(finder_width * scene.sensor.height / std::max(scene.sensor.width, 1), 1);
    options.aovs = {};
    if (command.from == BakeFrom::reference) options.bounces = 2;  // one set: its centres alone count
    return options;
}

/// Reflected light along the rays of the pencils; false if it was interrupted before every texel had a path.
bool trace_light(const Scene& scene, const BakeCommand& command, const ReferenceProgress& progress, PencilField& field) {
    ReferenceOptions options = command.paths;
    options.field = std::make_shared<PencilField>(field);
    options.bounces = true;
    if (scene.max_depth > 1) options.max_depth = scene.max_depth - 1;  // the film reflects once more
    options.seed = command.options.seed;
    const ReferenceResult result = trace_paths(scene, options, progress);
    for (const std::string& warning : result.warnings) print_warning(warning);
    const auto pixels = [&](const std::string& name) -> const std::vector<float>& {
        return std::find_if(result.layers.begin(), result.layers.end(), [&](const Layer& layer) { return layer.name == name; })->pixels;
    };
    const std::vector<float>&all = pixels(""), &emission = pixels("emission");
    for (std::size_t i = 0; i < field.light.size(); ++i) field.light[i] = std::max(all[i] - emission[i], 0.0F);
    return result.spp > 0;
}

}  // namespace

ExitCode run_bake(const BakeCommand& command) {
    const Stopwatch total;
    set_quiet(command.quiet);
    check_outputs({command.output}, {}, command.scene);
    if (image_format(command.output) != ImageFormat::exr) throw UsageError("--output: a field is an OpenEXR file, .exr");
    const Scene scene = load_scene(command.scene, command.load);
    for (const std::string& warning : scene.warnings) print_warning(warning);
    ProgressDisplay display(command.quiet ? ProgressDisplay::Style::none : ProgressDisplay::style_for(stderr));
    const auto progress = [&display](const std::string& stage, double fraction) {
        display.update(stage, fraction);
        return interrupted_by() == 0;
    };
    RenderResult result = render(scene, bake_options(command, scene), Device::open(command.device), progress);
    for (const std::string& warning : result.stats.warnings) print_warning(warning);
    if (!result.failure.empty() && interrupted_by() == 0) throw DeviceError(result.failure);
    bool whole = result.field && !result.interrupted;
    if (whole && command.from == BakeFrom::reference) whole = trace_light(scene, command, progress, *result.field);
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
