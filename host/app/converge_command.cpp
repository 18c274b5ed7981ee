// `pencil converge`: error against run time of every method and the path tracer, as CSV, JSON and a page.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/message.h"
#include "converge/converge.h"
#include "image/read_image.h"
#include "options/option_values.h"
#include "render/render_session.h"
#include "scene/formats/load_scene.h"
#include "util/error.h"
#include "util/log.h"
#include "util/progress.h"

namespace pencil {
namespace {

constexpr int standard_side = 256;  // [pixels] of the longer side

/// --resolution, else the reference's, else the scene's shape.
std::pair<int, int> image_size(const ConvergeCommand& command, const Scene& scene) {
    if (command.width > 0) return {command.width, command.height};
    if (!command.reference.empty()) {
        const Image reference = read_image(command.reference);
        return {reference.width, reference.height};
    }
    const int width = scene.sensor.width, height = scene.sensor.height, longer = std::max(width, height);
    return {std::max(1, width * standard_side / longer), std::max(1, height * standard_side / longer)};
}

/// What repeats this measurement.
std::string command_text(const ConvergeCommand& command, const ConvergeOptions& options) {
    std::string text = fmt::format("pencil converge {} -o {} --resolution {}x{} --seeds {} --longest {}", command.scene.string(),
                                   command.folder.string(), options.width, options.height, options.seeds, format_real(options.longest));
    const auto add = [&text](const std::string& option, const std::string& value) {
        text.append(" ").append(option).append(" ").append(value);
    };
    if (command.methods != method_names()) {
        std::string names = join(command.methods);
        names.erase(std::remove(names.begin(), names.end(), ' '), names.end());
        add("--methods", names.empty() ? "none" : names);
    }
    for (const auto& [name, value] : command.load.defines) {
        std::string define = name;
        add("-D", define.append("=").append(value));
    }
    return text + (command.reference.empty() ? "" : " --reference " + command.reference.string()) +
           (command.device.empty() ? "" : " --device " + command.device);
}

ConvergeOptions converge_options(const ConvergeCommand& command, const Scene& scene) {
    ConvergeOptions options;
    options.scene = command.scene;
    options.reference = command.reference;
    options.folder = command.folder;
    options.methods = command.methods;
    options.seeds = command.seeds;
    options.longest = command.longest;
    std::tie(options.width, options.height) = image_size(command, scene);
    options.bounces = resolve({}, scene).bounces;
    options.version = PENCIL_VERSION;
    options.command = command_text(command, options);
    return options;
}

void print_report(const Report& report) {
    std::cout << verdict_text(report);
    for (const char* file : {"points.csv", "summary.json", "index.html"})
        std::cout << "wrote    " << printable((report.options.folder / file).string()) << "\n";
}

}  // namespace

ExitCode run_converge(const ConvergeCommand& command) {
    set_quiet(command.quiet);
    const Scene scene = load_scene(command.scene, command.load);
    std::for_each(scene.warnings.begin(), scene.warnings.end(), print_warning);
    const ConvergeOptions options = converge_options(command, scene);
    const std::shared_ptr<Device> device = Device::open(command.device);
    prepare_folder(scene, options, device->info());

    Report report;
    {
        ProgressDisplay display(command.quiet ? ProgressDisplay::Style::none : ProgressDisplay::style_for(stderr));
        report = converge(scene, options, device, [&display](const std::string& stage, double fraction) {
            display.update(stage, fraction);
            return interrupted_by() == 0;
        });
    }
    std::for_each(report.warnings.begin(), report.warnings.end(), print_warning);
    if (!command.quiet && !report.points.empty()) print_report(report);
    if (!report.finished) {
        print_error(fmt::format("interrupted after {} runs; the same command goes on from there", report.points.size()));
        return ExitCode::interrupted;
    }
    return ExitCode::ok;
}

}  // namespace pencil
