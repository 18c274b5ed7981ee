// `pencil render`: everything that can be refused is refused before the device is opened, and what was rendered is always written.
#include <algorithm>
#include <chrono>
#include <iostream>
#include <set>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/message.h"
#include "app/outputs.h"
#include "app/run_report.h"
#include "cl/build_ahead.h"
#include "field/field_file.h"
#include "options/render_option_table.h"
#include "render/photometric_layers.h"
#include "render/render.h"
#include "render/render_session.h"
#include "scene/formats/load_scene.h"
#include "scene/scene_fingerprint.h"
#include "util/log.h"
#include "util/progress.h"
#include "util/stopwatch.h"

namespace pencil {
namespace {

/// Runs `work`, whose time becomes a stage of the report.
template <typename Work>
auto timed(RunReport& report, const std::string& name, Work work) -> decltype(work()) {
    struct AddStage {
        RunReport& report;
        const std::string& name;
        Stopwatch watch;
        ~AddStage() { report.stages.push_back({name, watch.seconds(), 0, 0, {}}); }
    } at_end{report, name, {}};
    return work();
}

void add_warnings(RunReport& report, const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) {
        print_warning(warning);
        report.warnings.push_back(warning);
    }
}

RenderResult render_with_progress(const Scene& scene, const RenderCommand& command, const RunReport& report,
                                  std::shared_ptr<Device>& device, const std::vector<std::shared_ptr<Device>>& helpers) {
    ProgressDisplay display(command.quiet ? ProgressDisplay::Style::none : ProgressDisplay::style_for(stderr));
    const Progress progress = [&display](const std::string& stage, double fraction) {
        display.update(stage, fraction);
        return interrupted_by() == 0;
    };
    RenderCare care{command.checkpoint, command.resume, helpers, {}};
    std::set<int> failed;
    care.next_device = [&](const Device& one) {
        failed.insert(one.info().index);
        std::shared_ptr<Device> next;
        if (!care.helpers.empty()) {
            next = care.helpers.front();
            care.helpers.erase(care.helpers.begin());
        } else if (command.device.empty()) {  // a device that was asked for by name is not replaced by another
            next = Device::open_another(failed);
        }
        if (next) device = next;
        return next;
    };
    const std::shared_ptr<Device> first = device;
    return render(scene, report.options, first, progress, care);
}

void take_result(RunReport& report, const RenderResult& result, Device& device) {
    report.stages.insert(report.stages.end(), result.stats.stages.begin(), result.stats.stages.end());
    report.stats = result.stats;
    report.width = result.width;
    report.height = result.height;
    report.interrupted = result.interrupted || !result.failure.empty();
    if (result.failure.empty()) report.launches = device.launch_times();  // a failed device has no more to say
    report.kernel_build_seconds = device.build_seconds();
    for (const Layer& layer : result.layers)
        if (!layer.name.empty()) report.layers.push_back(layer.name);
}

std::vector<std::filesystem::path> write_layers(RunReport& report, const RenderResult& result, const RenderCommand& command) {
    LayeredImage image{result.width, result.height, {}};
    std::transform(result.layers.begin(), result.layers.end(), std::back_inserter(image.layers), [](const Layer& layer) {
        return ImageLayer{layer.name, layer.channels, layer.pixels.data()};
    });
    const Metadata metadata = image_metadata(report, command, !command.stats.empty());
    const WrittenImages written = write_images(command.outputs, image, metadata, report.interrupted);
    add_warnings(report, written.warnings);
    return written.files;
}

/// The options with the field that is to be shown, whose pencils and maps are the render's.
RenderOptions with_field(RunReport& report, const RenderCommand& command) {
    RenderOptions options = command.options;
    if (command.field.empty()) return options;
    for (const std::filesystem::path& output : command.outputs)
        if (same_file(output, command.field)) throw OutputError("cannot write " + output.string() + ": it is the --field");
    timed(report, "load field", [&] { open_field(command.field, options); });
    return options;
}

}  // namespace

ExitCode run_render(const RenderCommand& command) {
    const Stopwatch total;
    RunReport report;
    set_quiet(command.quiet);
    allow_build_ahead("/proc/self/exe");
    check_outputs(command.outputs, {command.stats, command.checkpoint}, command.scene);
    const Scene scene = timed(report, "load scene", [&] { return load_scene(command.scene, command.load); });
    add_warnings(report, scene.warnings);
    report.scene_fingerprint = scene_fingerprint(scene);

    report.options = resolve(with_field(report, command), scene);
    report.width = report.options.width;
    report.height = report.options.height;
    if (has_photometric(command.options.aovs)) add_warnings(report, mixed_lights(scene, command.options.lumens_per_watt));
    check_film_memory(report.width, report.height, report.options.aovs);

    std::vector<std::shared_ptr<Device>> devices = timed(report, "open device", [&] { return Device::open_several(command.device); });
    std::shared_ptr<Device> device = devices.front();
    devices.erase(devices.begin());
    if (report.options.method != MethodName::surface) {
        if (!devices.empty() && !command.device.empty())
            throw UsageError("--method " + to_string(report.options.method) + " works on one device");
        devices.clear();
    }
    report.device = device->info();
    report.profile = device->profile();

    const RenderResult result = render_with_progress(scene, command, report, device, devices);
    report.device = device->info();  // another may have gone on
    take_result(report, result, *device);
    add_warnings(report, result.stats.warnings);
    if (result.layers.empty()) {
        print_error("interrupted before there was an image; nothing is written");
        return ExitCode::interrupted;
    }
    report.total_wall_seconds = total.seconds();
    const std::vector<std::filesystem::path> written = timed(report, "write images", [&] { return write_layers(report, result, command); });

    report.total_wall_seconds = total.seconds();
    if (!command.stats.empty()) write_stats(command.stats, report, command);
    if (command.explain) print_explanation(std::cout, report);
    if (!command.quiet) print_summary(std::cout, report, written);
    // A signal takes files away from a driver that is building a kernel: no failure of its own.
    if (!result.failure.empty() && interrupted_by() == 0) {
        print_error(result.failure + "; what was finished is written", LineBreaks::keep);
        return ExitCode::device;
    }
    if (report.interrupted) {
        print_error(interruption(written));
        return ExitCode::interrupted;
    }
    return report.stats.converged ? ExitCode::ok : ExitCode::not_converged;
}

}  // namespace pencil
