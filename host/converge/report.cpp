#include "converge/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "converge/text.h"

namespace pencil {
namespace {

constexpr double noticeable_noise = 1.0;  // relMSE of the reference over the smallest that is measured
constexpr double busy = 2;                // load per core: our own runs keep about one process per core running
constexpr std::size_t few_points = 5;
constexpr double short_range = 30;  // longest over shortest time

std::string verdict_line(const Report& report, const std::vector<NamedCurve>& curves, double seconds) {
    const ErrorMetric& metric = error_metrics().front();
    const Verdict verdict = judge(curves, seconds);
    const std::string when = fmt::format("after {}: ", seconds_text(seconds));
    if (verdict.ahead < 0) {
        return when + "no method is measured there";
    }
    const auto method = [&](int index) {
        const auto i = static_cast<std::size_t>(index);
        return fmt::format("{} ({})", report.methods[i].name, value_text(metric, verdict.errors[i].value));
    };
    if (verdict.second < 0) {
        return fmt::format("{}only {} is measured there", when, method(verdict.ahead));
    }
    if (verdict.lead < level) {
        return fmt::format("{}{} is level with {}", when, method(verdict.ahead), method(verdict.second));
    }
    return fmt::format("{}{} is ahead of {} by a factor of {}", when, method(verdict.ahead), method(verdict.second),
                       round_text(verdict.lead));
}

}  // namespace

std::vector<NamedCurve> curves_of(const Report& report, const ErrorMetric& metric) {
    std::vector<NamedCurve> curves;
    curves.reserve(report.methods.size());
    for (const MethodSummary& method : report.methods) {
        curves.push_back({method.name, curve_of(method, metric)});
    }
    return curves;
}

std::vector<std::string> run_warnings(const Report& report) {
    std::vector<std::string> warnings;
    double load = 0;
    for (const RunPoint& point : report.points) {
        load = std::max(load, point.load);
    }
    if (load > busy * std::max(report.host_threads, 1U)) {
        warnings.push_back(
            fmt::format("other programs used this machine (load {} on {} cores): times are too long and curves not "
                        "comparable; measure again on an idle machine",
                        round_text(load), report.host_threads));
    }
    double smallest = std::numeric_limits<double>::infinity();
    for (const MethodSummary& method : report.methods) {
        const Curve curve = curve_of(method, error_metrics().front());
        for (const CurvePoint& point : curve) {
            smallest = std::min(smallest, point.error * point.error);
        }
        if (report.finished && (curve.size() < few_points || curve.back().seconds < short_range * curve.front().seconds)) {
            const std::string range =
                curve.empty() ? "" : fmt::format(" over a {}-fold range of time", round_text(curve.back().seconds / curve.front().seconds));
            warnings.push_back(
                fmt::format("the curve of {} has {} points{}; a larger --longest shows more", method.name, curve.size(), range));
        }
    }
    const std::optional<double>& noise = report.truth.noise_rel_mse;
    if (noise && *noise > noticeable_noise * smallest) {
        warnings.push_back(
            fmt::format("the noise of the reference, relMSE {}, is {} of the smallest relMSE that is left when it is taken "
                        "off; give a better --reference",
                        round_text(*noise), percent_text(*noise / smallest)));
    }
    return warnings;
}

std::string value_text(const ErrorMetric& metric, double value) { return metric.percent ? percent_text(value) : round_text(value); }

std::string verdict_text(const Report& report) {
    std::string text;
    for (const double seconds : verdict_times) {
        text += verdict_line(report, curves_of(report, error_metrics().front()), seconds) + "\n";
    }
    return text;
}

}  // namespace pencil
