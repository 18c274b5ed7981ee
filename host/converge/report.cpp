#include "converge/report.h"

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

std::string value_text(const ErrorMetric& metric, double value) { return metric.percent ? percent_text(value) : round_text(value); }

std::string verdict_line(const Report& report, const std::vector<NamedCurve>& curves, double seconds) {
    const ErrorMetric& metric = error_metrics().front();
    const Verdict verdict = judge(curves, seconds);
    std::string line = "after " + seconds_text(seconds) + ": ";
    if (verdict.ahead < 0) {
        return line + "no method is measured there";
    }
    const auto method = [&](int index) {
        return report.methods[static_cast<std::size_t>(index)].name + " (" +
               value_text(metric, verdict.errors[static_cast<std::size_t>(index)].value) + ")";
    };
    if (verdict.second < 0) {
        return line + "only " + method(verdict.ahead) + " is measured there";
    }
    if (verdict.lead < level) {
        return line + method(verdict.ahead) + " is level with " + method(verdict.second);
    }
    return line + method(verdict.ahead) + " is ahead of " + method(verdict.second) + " by a factor of " + round_text(verdict.lead);
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
        warnings.push_back("other programs used this machine (load " + round_text(load) + " on " + std::to_string(report.host_threads) +
                           " cores): times are too long and curves not comparable; measure again on an idle machine");
    }
    double smallest = std::numeric_limits<double>::infinity();
    for (const MethodSummary& method : report.methods) {
        const Curve curve = curve_of(method, error_metrics().front());
        for (const CurvePoint& point : curve) {
            smallest = std::min(smallest, point.error * point.error);
        }
        if (report.finished && (curve.size() < few_points || curve.back().seconds < short_range * curve.front().seconds)) {
            warnings.push_back("the curve of " + method.name + " has " + std::to_string(curve.size()) + " points" +
                               (curve.empty()
                                    ? std::string()
                                    : " over a " + round_text(curve.back().seconds / curve.front().seconds) + "-fold range of time") +
                               "; a larger --longest shows more");
        }
    }
    const std::optional<double>& noise = report.truth.noise_rel_mse;
    if (noise && *noise > noticeable_noise * smallest) {
        warnings.push_back("the noise of the reference, relMSE " + round_text(*noise) + ", is " + percent_text(*noise / smallest) +
                           " of the smallest relMSE that is left when it is taken off; give a better --reference");
    }
    return warnings;
}

std::string verdict_text(const Report& report) {
    std::string text;
    for (const double seconds : verdict_times) {
        text += verdict_line(report, curves_of(report, error_metrics().front()), seconds) + "\n";
    }
    return text;
}

}  // namespace pencil
