// --stats of `reference`. The keys are a contract with programs that read them: `schema` counts incompatible changes, new keys may appear
// without. Times are in seconds.
#include "app/reference_report.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/message.h"
#include "app/option_report.h"
#include "app/options.h"
#include "app/run_report.h"
#include "options/option_values.h"
#include "util/format.h"
#include "util/output_file.h"

namespace pencil {
namespace {

using Json = nlohmann::ordered_json;

constexpr int reference_schema = 1;

double per_second(std::uint64_t count, double seconds) { return seconds > 0 ? static_cast<double>(count) / seconds : 0; }

Json all_options_json(const ReferenceReport& report, const ReferenceCommand& command) {
    ReferenceCommand used = command;
    used.options = report.options;
    used.lumens_per_watt = report.lumens_per_watt;
    Json json = options_json(option_table(used));
    json["resolution"] = {report.options.width, report.options.height};
    json["defines"] = command.load.defines;
    for (const std::filesystem::path& output : command.outputs) json["output"].push_back(output.string());
    return json;
}

Json stages_json(const ReferenceReport& report) {
    Json stages = Json::array();
    const auto add = [&](const char* name, double seconds) { stages.push_back({{"name", name}, {"wall_seconds", seconds}}); };
    add("load scene", report.load_seconds);
    add("build BVH", report.result.build_seconds);
    add("trace paths", report.result.trace_seconds);
    add("write images", report.write_seconds);
    return stages;
}

}  // namespace

void print_summary(std::ostream& out, const ReferenceReport& report, const std::vector<std::filesystem::path>& written) {
    const ReferenceResult& result = report.result;
    out << "time     " << format_short(report.load_seconds) << " s load scene, " << format_short(result.build_seconds) << " s build BVH, "
        << format_short(result.trace_seconds) << " s trace paths, " << format_short(report.write_seconds) << " s write images\n"
        << "paths    " << result.paths << ", " << format_short(per_second(result.paths, result.trace_seconds) / 1e6)
        << " million/s\nrays     " << result.rays << ", " << format_short(per_second(result.rays, result.trace_seconds) / 1e6)
        << " million/s\nmemory   " << format_size(peak_resident_bytes()) << " resident at most\nimage    " << result.width << "x"
        << result.height << ", " << result.spp << " paths per pixel, estimated relMSE "
        << (std::isfinite(result.estimated_error) ? format_short(result.estimated_error) : "unknown with one path") << "\n";
    for (const std::filesystem::path& file : written) out << "wrote    " << printable(file.string()) << "\n";
}

Metadata image_metadata(const ReferenceReport& report, const ReferenceCommand& command, bool times) {
    Metadata metadata{
        {"Software", "pencil " PENCIL_VERSION},
        {"pencil:version", PENCIL_VERSION},
        {"pencil:method", "path tracing"},
        {"pencil:scene", command.scene.filename().string()},
        {"pencil:sceneFingerprint", report.scene_fingerprint},
    };
    ReferenceCommand used = command;
    used.options = report.options;
    used.lumens_per_watt = report.lumens_per_watt;
    add_options(metadata, option_table(used));
    metadata["pencil:spp"] = report.result.spp;  // as traced, whatever was asked for
    for (const auto& [name, value] : command.load.defines) metadata["pencil:define:" + name] = value;
    if (report.result.interrupted) metadata["pencil:interrupted"] = 1;
    if (times) {
        metadata["pencil:wallSeconds"] = report.total_seconds;
        metadata["pencil:traceSeconds"] = report.result.trace_seconds;
    }
    return metadata;
}

void write_stats(const std::filesystem::path& file, const ReferenceReport& report, const ReferenceCommand& command) {
    const ReferenceResult& result = report.result;
    const Json json{{"schema", reference_schema},
                    {"version", PENCIL_VERSION},
                    {"method", "path tracing"},
                    {"scene", command.scene.string()},
                    {"options", all_options_json(report, command)},
                    {"interrupted", result.interrupted},
                    {"layers", report.layers},
                    {"stages", stages_json(report)},
                    {"total_wall_seconds", report.total_seconds},
                    {"spp", result.spp},
                    {"estimated_relmse", result.estimated_error},
                    {"paths", result.paths},
                    {"rays", result.rays},
                    {"paths_per_second", per_second(result.paths, result.trace_seconds)},
                    {"rays_per_second", per_second(result.rays, result.trace_seconds)},
                    {"peak_rss_bytes", peak_resident_bytes()},
                    {"warnings", report.warnings}};
    const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    write_file(file, text.data(), text.size());
}

}  // namespace pencil
