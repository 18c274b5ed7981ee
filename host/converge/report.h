// Everything the reader of a measurement wants to know: the input of summary.json and of the page.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cl/device.h"
#include "converge/options.h"
#include "converge/summary.h"
#include "converge/truth.h"
#include "converge/verdict.h"

namespace pencil {

/// Times at which methods are compared [s].
constexpr std::array<double, 3> verdict_times{0.1, 1, 10};

struct Report {
    ConvergeOptions options;
    Truth truth;
    std::vector<MethodSummary> methods;
    std::vector<RunPoint> points;
    DeviceInfo device;
    unsigned host_threads = 0;
    bool finished = false;  // no run is missing
    std::vector<std::string> warnings;
};

/// What the runs themselves tell: a busy machine, noise of the reference, few points, a short range of time.
std::vector<std::string> run_warnings(const Report& report);

/// Curves of one metric, the path tracer's first.
std::vector<NamedCurve> curves_of(const Report& report, const ErrorMetric& metric);

/// A value of the metric as readers see it: "4.2 %" or "0.013".
std::string value_text(const ErrorMetric& metric, double value);

/// The verdicts in plain text, for the terminal.
std::string verdict_text(const Report& report);

/// The report as summary.json. Its keys are a contract: `schema` counts incompatible changes; what is not measured is null.
std::string summary_json(const Report& report);

/// The page; `plots_missing` says why there are no plots, or nothing.
std::string page_html(const Report& report, const std::string& plots_missing);

}  // namespace pencil
