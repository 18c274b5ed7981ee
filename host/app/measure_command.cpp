// `pencil measure`: a table of illuminances.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/message.h"
#include "app/outputs.h"
#include "measure/measure.h"
#include "measure/measurements_csv.h"
#include "render/photometric_layers.h"
#include "scene/formats/load_scene.h"
#include "util/log.h"
#include "util/output_file.h"
#include "util/progress.h"
#include "util/stopwatch.h"

namespace pencil {
namespace {

void check_output(const MeasureCommand& command) {
    if (command.output.empty()) return;
    if (same_file(command.output, command.scene)) throw OutputError("cannot write " + command.output.string() + ": it is the scene");
    if (same_file(command.output, command.points)) throw OutputError("cannot write " + command.output.string() + ": it holds the points");
    check_writable(command.output);
}

std::vector<Sensor> sensors_of(const MeasureCommand& command, const Scene& scene) {
    std::vector<SensorPoint> points;
    if (!command.points.empty()) points = read_sensor_points(command.points);
    const auto too_many = [] { return UsageError(fmt::format("more than {} sensors: give fewer --grid or --points", most_sensors)); };
    for (const SensorGrid& grid : command.grids) {
        const std::vector<SensorPoint> more = grid_points(grid);
        points.insert(points.end(), more.begin(), more.end());
        if (points.size() > most_sensors) throw too_many();
    }
    std::vector<Sensor> sensors = all_sensors(points, scene);
    if (sensors.empty()) throw UsageError("there is nothing to measure: give --points or --grid, or a scene with irradiance meters");
    if (sensors.size() > most_sensors) throw too_many();
    return sensors;
}

ReferenceOptions path_options(const MeasureCommand& command, const Scene& scene) {
    ReferenceOptions options;
    options.seconds = command.seconds;
    options.seed = command.options.seed;
    const int bounces = command.options.bounces;
    if (bounces != bounces_of_scene) options.max_depth = bounces < 0 ? -1 : bounces + 1;
    if (options.max_depth == depth_of_scene) options.max_depth = scene.max_depth;
    return options;
}

Measurements measure_with_progress(const MeasureCommand& command, const Scene& scene, const std::vector<Sensor>& sensors) {
    ProgressDisplay display(command.quiet ? ProgressDisplay::Style::none : ProgressDisplay::style_for(stderr));
    const auto progress = [&display](const std::string& stage, double fraction) {
        display.update(stage, fraction);
        return interrupted_by() == 0;
    };
    if (command.method == MeasureMethod::surface) return measure(scene, sensors, command.options, Device::open(command.device), progress);
    return measure_by_paths(scene, sensors, path_options(command, scene),
                            efficacy_of(command.options.lumens_per_watt, scene.photometric_lights > 0), progress);
}

std::string summary(const Measurements& found, double seconds) {
    std::string text = fmt::format("measured {} sensors in {:.1f} s", found.sensors.size(), seconds);
    if (found.passes > 0) text += fmt::format(", {} passes", found.passes);
    if (found.certified.points > 1)
        text += fmt::format("; light paths say: mean off by {:+.2f} % +- {:.2f} %", 100 * found.certified.mean_bias,
                            100 * interval_errors * found.certified.mean_error);
    return text;
}

void write_table(const MeasureCommand& command, const std::string& table) {
    if (command.output.empty()) {
        std::cout << table << std::flush;
        return;
    }
    write_file(command.output, table.data(), table.size());
    log_info("wrote " + printable(command.output.string()));
}

}  // namespace

ExitCode run_measure(const MeasureCommand& command) {
    const Stopwatch total;
    set_quiet(command.quiet);
    check_output(command);
    const Scene scene = load_scene(command.scene, command.load);
    std::for_each(scene.warnings.begin(), scene.warnings.end(), print_warning);
    for (const std::string& warning : mixed_lights(scene, command.options.lumens_per_watt)) print_warning(warning);
    const std::vector<Sensor> sensors = sensors_of(command, scene);
    const Measurements found = measure_with_progress(command, scene, sensors);
    std::for_each(found.warnings.begin(), found.warnings.end(), print_warning);
    if (found.sensors.empty()) {
        print_error("interrupted before anything was measured; nothing is written");
        return ExitCode::interrupted;
    }
    log_info(summary(found, total.seconds()));
    write_table(command, measurements_csv(sensors, found));
    if (found.interrupted) {
        print_error("interrupted; what was measured until then is written");
        return ExitCode::interrupted;
    }
    return found.converged ? ExitCode::ok : ExitCode::not_converged;
}

}  // namespace pencil
