// --stats. The keys are a contract with programs that read them: `schema` counts incompatible changes, new keys may appear without.
// Sizes are in bytes, times in seconds; a number that is not finite becomes null.
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/option_report.h"
#include "app/run_report.h"
#include "options/render_option_table.h"
#include "util/output_file.h"

namespace pencil {
namespace {

using Json = nlohmann::ordered_json;

constexpr int stats_schema = 1;

Json all_options_json(const RunReport& report, const RenderCommand& command) {
    RenderOptions options = report.options;
    Json json = options_json(render_option_table(options));
    json["resolution"] = {report.width, report.height};
    json["defines"] = command.load.defines;
    for (const std::filesystem::path& output : command.outputs) json["output"].push_back(output.string());
    return json;
}

/// How kernels were built and launched; `tuned`: by what `pencil tune` has measured.
Json profile_json(const DeviceProfile& profile) {
    return {{"tuned", profile.tuned},
            {"packet_width", profile.packet_width},
            {"block", profile.block},
            {"group", profile.group},
            {"groups", profile.groups},
            {"map_costs", profile.map_costs},
            {"atlas_image", profile.atlas_image}};
}

Json device_json(const RunReport& report) {
    const DeviceInfo& device = report.device;
    return {{"name", device.name},
            {"platform", device.platform},
            {"vendor", device.vendor},
            {"driver", device.driver},
            {"version", device.version},
            {"is_cpu", device.is_cpu},
            {"compute_units", device.compute_units},
            {"global_memory", device.global_memory},
            {"packet_width", report.profile.packet_width},
            {"profile", profile_json(report.profile)}};
}

Json launches_json(const std::map<std::string, LaunchTimes>& by_description) {
    Json launches = Json::object();
    for (const auto& [description, times] : by_description)
        launches[description] = {{"launches", times.launches}, {"device_seconds", times.device_seconds}};
    return launches;
}

Json stages_json(const RunReport& report) {
    Json stages = Json::array();
    for (const StageTime& stage : report.stages) {
        stages.push_back({{"name", stage.name},
                          {"wall_seconds", stage.wall_seconds},
                          {"device_seconds", stage.device_seconds},
                          {"launches", stage.launches},
                          {"kernel_launches", launches_json(stage.kernels)}});
    }
    return stages;
}

Json bounces_json(const RenderStats& stats) {
    Json bounces = Json::array();
    for (const BounceReport& bounce : stats.bounces) {
        bounces.push_back({{"order", bounce.order},
                           {"pencils", bounce.pencils},
                           {"mean", {bounce.mean.x, bounce.mean.y, bounce.mean.z}},
                           {"projection_seconds", bounce.projection_seconds}});
    }
    return bounces;
}

/// How reflections between pencils were added up; null where none were.
Json bounce_solve_json(const BounceSolve& solve) {
    if (solve.steps == 0) return {};
    return {{"steps", solve.steps},
            {"krylov_applications", solve.krylov},
            {"spectral_radius", solve.spectral_radius},
            {"has_sum", solve.has_sum}};
}

/// What light paths say of the image; null without a check.
Json certified_json(const CertifiedError& certified) {
    if (certified.points < 2) return {};
    const auto interval = [](double value, double error) { return Json{value - interval_errors * error, value + interval_errors * error}; };
    return {{"relmse", certified.relmse},
            {"relmse_interval", interval(certified.relmse, certified.standard_error)},
            {"mean_bias", certified.mean_bias},
            {"mean_bias_interval", interval(certified.mean_bias, certified.mean_error)},
            {"pixels", certified.points}};
}

}  // namespace

void write_stats(const std::filesystem::path& file, const RunReport& report, const RenderCommand& command) {
    const RenderStats& stats = report.stats;
    const Json json{{"schema", stats_schema},
                    {"version", PENCIL_VERSION},
                    {"scene", command.scene.string()},
                    {"options", all_options_json(report, command)},
                    {"device", device_json(report)},
                    {"driver", report.device.driver},
                    {"interrupted", report.interrupted},
                    {"layers", report.layers},
                    {"stages", stages_json(report)},
                    {"kernel_launches", launches_json(report.launches)},
                    {"kernel_build_seconds", report.kernel_build_seconds},
                    {"total_wall_seconds", report.total_wall_seconds},
                    {"bounces", bounces_json(stats)},
                    {"passes", stats.passes},
                    {"certified", certified_json(stats.certified)},
                    {"estimated_relmse", std::isfinite(stats.estimated_error) ? Json(stats.estimated_error) : Json()},
                    {"world_pencils", stats.world_pencils},
                    {"film_pencils", stats.film_pencils},
                    {"device_pencils", stats.device_pencils},
                    {"field_pencils", stats.field_pencils},
                    {"field_pencils_read", stats.field_read},
                    {"residual", stats.residual},
                    {"tail_closed", stats.tail_closed},
                    {"converged", stats.converged},
                    {"bounce_solve", bounce_solve_json(stats.bounce_solve)},
                    {"triangles", stats.triangles},
                    {"film_surfels", stats.film_surfels},
                    {"blind_surfels", stats.blind_surfels},
                    {"peak_rss_bytes", peak_resident_bytes()},
                    {"device_peak_bytes", stats.device_peak_bytes},
                    {"explain", stats.explain},
                    {"warnings", report.warnings}};
    // Names in scene files and drivers need not be valid UTF-8; JSON must be.
    const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    write_file(file, text.data(), text.size());
}

}  // namespace pencil
