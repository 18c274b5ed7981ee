#include <nlohmann/json.hpp>

#include "converge/report.h"

namespace pencil {
namespace {

using Json = nlohmann::ordered_json;

constexpr int schema = 1;

Json optional_json(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json stages_json(const BudgetSummary& budget) {
    Json stages = Json::object();
    for (const auto& [name, seconds] : budget.stages) stages[name] = seconds;
    return stages;
}

Json budget_json(const BudgetSummary& budget) {
    Json json{{"budget", budget.budget}, {"options", budget.options}, {"seeds", budget.seeds}, {"seconds", budget.seconds}};
    for (const ErrorMetric& metric : error_metrics()) json[metric.key] = budget.*metric.value;
    json["mean_ratio"] = budget.mean_ratio;
    json["bias"] = optional_json(budget.bias);
    json["noise"] = optional_json(budget.noise);
    json["stages"] = stages_json(budget);
    return json;
}

Json fit_json(const Curve& curve) {
    const std::optional<PowerLaw> law = fit_power_law(curve);
    const std::optional<FloorFit> floor = fit_floor(curve);
    return {{"slope", law ? Json(law->slope) : Json()},
            {"coefficient", law ? Json(law->coefficient) : Json()},
            {"floor", floor && floor->visible ? Json(floor->floor) : Json()},
            {"floor_visible", floor && floor->visible}};
}

Json method_json(const MethodSummary& method) {
    Json json{{"name", method.name}, {"summary", method.summary}, {"budgets", Json::array()}, {"fits", Json::object()}};
    for (const BudgetSummary& budget : method.budgets) json["budgets"].push_back(budget_json(budget));
    for (const ErrorMetric& metric : error_metrics()) json["fits"][metric.key] = fit_json(curve_of(method, metric));
    return json;
}

/// A value, or null with the reason in words.
Json reading_json(const Reading& reading) {
    if (reading.kind == Reading::Kind::measured) return {{"value", reading.value}, {"state", "measured"}};
    const bool before = reading.kind == Reading::Kind::before_first;
    return {{"value", nullptr},
            {"state", before ? "before first point" : "not reached"},
            {before ? "first_seconds" : "last_seconds", reading.value}};
}

Json equal_time_json(const std::vector<NamedCurve>& curves, double seconds) {
    const Verdict verdict = judge(curves, seconds);
    const auto name = [&](int index) { return index < 0 ? Json() : Json(curves[static_cast<std::size_t>(index)].name); };
    Json json{{"seconds", seconds},
              {"ahead", name(verdict.ahead)},
              {"second", name(verdict.second)},
              {"lead", verdict.second < 0 ? Json() : Json(verdict.lead)},
              {"errors", Json::object()}};
    for (std::size_t i = 0; i < curves.size(); ++i) json["errors"][curves[i].name] = reading_json(verdict.errors[i]);
    return json;
}

Json equal_error_json(const std::vector<NamedCurve>& curves, double error) {
    const TimesToError row = times_to(curves, error);
    Json json{{"error", error}, {"times", Json::object()}, {"speedups", Json::object()}};
    for (std::size_t i = 0; i < curves.size(); ++i) {
        json["times"][curves[i].name] = reading_json(row.times[i]);
        json["speedups"][curves[i].name] = row.speedups[i] > 0 ? Json(row.speedups[i]) : Json();
    }
    return json;
}

Json comparison_json(const Report& report, const ErrorMetric& metric) {
    const std::vector<NamedCurve> curves = curves_of(report, metric);
    Json json{{"equal_time", Json::array()}, {"equal_error", Json::array()}};
    for (const double seconds : verdict_times) json["equal_time"].push_back(equal_time_json(curves, seconds));
    for (const double error : round_errors(curves)) json["equal_error"].push_back(equal_error_json(curves, error));
    return json;
}

}  // namespace

std::string summary_json(const Report& report) {
    const ConvergeOptions& options = report.options;
    Json json{{"schema", schema},
              {"version", options.version},
              {"command", options.command},
              {"finished", report.finished},
              {"scene", options.scene.string()},
              {"size", {options.width, options.height}},
              {"bounces", options.bounces < 0 ? Json("auto") : Json(options.bounces)},
              {"seeds", options.seeds},
              {"longest_seconds", options.longest},
              {"device", {{"name", report.device.name}, {"platform", report.device.platform}, {"driver", report.device.driver}}},
              {"host_threads", report.host_threads},
              {"reference",
               {{"file", report.truth.name},
                {"origin", report.truth.origin},
                {"noise_rel_mse", optional_json(report.truth.noise_rel_mse)},
                {"exposure", report.truth.exposure},
                {"fingerprint", report.truth.fingerprint}}},
              {"methods", Json::array()},
              {"comparison", Json::object()},
              {"warnings", report.warnings}};
    for (const MethodSummary& method : report.methods) json["methods"].push_back(method_json(method));
    for (const ErrorMetric& metric : error_metrics()) json["comparison"][metric.key] = comparison_json(report, metric);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace pencil
