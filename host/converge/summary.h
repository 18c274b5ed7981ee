// The runs put together: one line per method and budget, curves, and their comparison with each other and with the path tracer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "converge/curve.h"
#include "converge/points.h"
#include "converge/truth.h"

namespace pencil {

struct BudgetSummary {
    int budget = 0;
    std::string options;
    std::vector<std::uint64_t> seeds;                    // that are finished
    double seconds = 0;                                  // median
    double relative_error = 0, rmse = 0, lab_rms = 0;    // roots of mean squares over the seeds; relative: sqrt(relMSE)
    double mean_ratio = 0;                               // mean over the seeds
    std::optional<double> bias, noise;                   // parts of the relative error that all seeds share, and that they do not
    std::vector<std::pair<std::string, double>> stages;  // median wall seconds
};

struct MethodSummary {
    std::string name, summary;
    std::vector<BudgetSummary> budgets;  // those with runs, ascending
};

/// What curves can show.
struct ErrorMetric {
    const char* key;    // in JSON
    const char* title;  // on the page
    double BudgetSummary::*value;
    bool percent;  // shown in percent
};
const std::vector<ErrorMetric>& error_metrics();

/// The path tracer first, then `options.methods`; those without runs, and seeds from `options.seeds` on, are left out. Reads the runs'
/// images for bias and noise.
std::vector<MethodSummary> summarise(const std::vector<RunPoint>& points, const ConvergeOptions& options, const Truth& truth);

Curve curve_of(const MethodSummary& method, const ErrorMetric& metric);

/// Squares: the error of one run is bias^2 + noise^2, that of the mean of n runs is bias^2 + noise^2 / n.
struct BiasAndNoise {
    double bias = 0, noise = 0;
};
BiasAndNoise split_error(double single_square, double mean_square, int n);

}  // namespace pencil
