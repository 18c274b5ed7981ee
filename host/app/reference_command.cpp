// `pencil reference`: refuses early what can be refused, and always writes what was traced.
#include <algorithm>
#include <chrono>
#include <iostream>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/message.h"
#include "app/outputs.h"
#include "app/reference_report.h"
#include "render/photometric_layers.h"
#include "scene/formats/load_scene.h"
#include "scene/scene_fingerprint.h"
#include "util/log.h"
#include "util/progress.h"
#include "util/stopwatch.h"

namespace pencil {
namespace {

void add_warnings(ReferenceReport& report, const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) {
        print_warning(warning);
        report.warnings.push_back(warning);
    }
}

ReferenceOptions options_for(const ReferenceCommand& command, const Scene& scene) {
    ReferenceOptions options = command.options;
    if (options.max_depth == depth_of_scene) options.max_depth = scene.max_depth;
    if (options.width <= 0) {
        const PerspectiveSensor& sensor = scene.sensor;
        options.width = sensor.crop_width > 0 ? sensor.crop_width : sensor.width;
        options.height = sensor.crop_width > 0 ? sensor.crop_height : sensor.height;
    }
    const auto wants_any = [&](const std::vector<std::string>& names) {
        return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return has_group(command.aovs, name); });
    };
    options.bounces = wants_any(light_groups());
    options.surfaces = wants_any(surface_groups());
    options.variance = wants_any({variance_layer});
    return options;
}

ReferenceResult trace_with_progress(const Scene& scene, const ReferenceCommand& command, const ReferenceOptions& options) {
    ProgressDisplay display(command.quiet ? ProgressDisplay::Style::none : ProgressDisplay::style_for(stderr));
    return trace_paths(scene, options, [&display](const std::string& stage, double fraction) {
        display.update(stage, fraction);
        return interrupted_by() == 0;
    });
}

/// Photometric layers; illuminance is a trace of its own.
void add_photometric(const ReferenceCommand& command, const Scene& scene, ReferenceReport& report) {
    ReferenceResult& result = report.result;
    const auto solve = [&]() -> IrradianceImage {
        if (result.interrupted) return {{}, {}, true, true};
        ReferenceOptions options = report.options;
        options.irradiance = true;
        options.bounces = options.surfaces = options.variance = false;
        ReferenceResult found = trace_with_progress(scene, command, options);
        return {std::move(found.layers), std::move(found.warnings), found.interrupted, true};
    };
    const IrradianceImage irradiance = add_photometric_layers(command.aovs, report.lumens_per_watt, solve, result.layers);
    result.warnings.insert(result.warnings.end(), irradiance.warnings.begin(), irradiance.warnings.end());
    result.interrupted = result.interrupted || irradiance.interrupted;
}

/// The layers come in groups; those that nobody asked for are dropped here.
bool is_wanted(const Layer& layer, const std::vector<std::string>& aovs) {
    return layer.name.empty() || has_group(aovs, is_bounce(layer.name) ? bounces_group : layer.name);
}

std::vector<std::filesystem::path> write_layers(ReferenceReport& report, const ReferenceCommand& command) {
    LayeredImage image{report.result.width, report.result.height, {}};
    for (const Layer& layer : report.result.layers) {
        if (is_wanted(layer, command.aovs)) {
            image.layers.push_back({layer.name, layer.channels, layer.pixels.data()});
            if (!layer.name.empty()) report.layers.push_back(layer.name);
        }
    }
    const Metadata metadata = image_metadata(report, command, !command.stats.empty());
    const WrittenImages written = write_images(command.outputs, image, metadata, report.result.interrupted);
    add_warnings(report, written.warnings);
    return written.files;
}

}  // namespace

ExitCode run_reference(const ReferenceCommand& command) {
    const Stopwatch total;
    ReferenceReport report;
    set_quiet(command.quiet);
    check_outputs(command.outputs, {command.stats}, command.scene);
    const Scene scene = load_scene(command.scene, command.load);
    report.load_seconds = total.seconds();
    add_warnings(report, scene.warnings);
    report.scene_fingerprint = scene_fingerprint(scene);
    report.options = options_for(command, scene);
    report.lumens_per_watt = efficacy_of(command.lumens_per_watt, scene.photometric_lights > 0);
    if (has_photometric(command.aovs)) add_warnings(report, mixed_lights(scene, command.lumens_per_watt));
    check_film_memory(report.options.width, report.options.height, command.aovs);

    report.result = trace_with_progress(scene, command, report.options);
    add_photometric(command, scene, report);
    add_warnings(report, report.result.warnings);
    report.total_seconds = total.seconds();
    const Stopwatch writing;
    const std::vector<std::filesystem::path> written = write_layers(report, command);
    report.write_seconds = writing.seconds();
    report.total_seconds = total.seconds();
    if (!command.stats.empty()) write_stats(command.stats, report, command);
    if (!command.quiet) print_summary(std::cout, report, written);
    if (report.result.interrupted) {
        print_error(interruption(written));
        return ExitCode::interrupted;
    }
    return ExitCode::ok;
}

}  // namespace pencil
