#include "converge/summary.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "compare/image_layers.h"
#include "compare/metrics.h"
#include "converge/methods.h"
#include "converge/runs.h"

namespace pencil {
namespace {

using Points = std::vector<const RunPoint*>;

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

template <typename Value>
double mean(const Points& points, Value value) {
    double sum = 0;
    for (const RunPoint* point : points) sum += value(*point);
    return sum / static_cast<double>(points.size());
}

std::vector<std::pair<std::string, double>> median_stages(const Points& points) {
    std::vector<std::pair<std::string, double>> stages = points.front()->stages;
    for (auto& [name, seconds] : stages) {
        std::vector<double> times;
        for (const RunPoint* point : points) {
            for (const auto& [other, time] : point->stages)
                if (other == name) times.push_back(time);
        }
        seconds = median(times);
    }
    return stages;
}

/// relMSE of the mean over the seeds' images; nothing if an image is gone.
std::optional<double> square_of_mean(const BudgetSummary& budget, const std::string& method, const ConvergeOptions& options,
                                     const Truth& truth) {
    std::vector<double> sum(truth.rgb.size());
    for (const std::uint64_t seed : budget.seeds) {
        const std::filesystem::path file = image_file(options, method, budget.budget, seed);
        if (!std::filesystem::exists(file)) return {};
        const std::vector<float> rgb = split_layers(read_image(file)).front().pixels;
        if (rgb.size() != sum.size()) return {};
        std::transform(sum.begin(), sum.end(), rgb.begin(), sum.begin(), [](double total, float value) { return total + value; });
    }
    const double n = static_cast<double>(budget.seeds.size());
    std::vector<float> rgb(sum.size());
    std::transform(sum.begin(), sum.end(), rgb.begin(), [n](double total) { return static_cast<float>(total / n); });
    return measure({rgb.data(), truth.rgb.data(), rgb.size() / 3, 3}).rel_mse;
}

/// relMSE without the noise of the reference, which adds to it; the estimate of that noise is good to a few per cent at best.
double above_reference_noise(double rel_mse, const Truth& truth) {
    constexpr double least = 0.05;
    return std::max(rel_mse - truth.noise_rel_mse.value_or(0.0), least * rel_mse);
}

BudgetSummary summarise_budget(const Points& points, const ConvergeOptions& options, const Truth& truth) {
    BudgetSummary budget;
    budget.budget = points.front()->budget;
    budget.options = points.front()->options;
    std::vector<double> seconds;
    for (const RunPoint* point : points) {
        budget.seeds.push_back(point->seed);
        seconds.push_back(point->seconds);
    }
    budget.seconds = median(seconds);
    const double square = above_reference_noise(mean(points, [](const RunPoint& p) { return p.rel_mse; }), truth);
    budget.relative_error = std::sqrt(square);
    budget.rmse = std::sqrt(mean(
        points, [](const RunPoint& p) { return p.rmse * p.rmse; }));
    budget.lab_rms = std::sqrt(mean(
        points, [](const RunPoint& p) { return p.lab_rms * p.lab_rms; }));
    budget.mean_ratio = mean(points, [](const RunPoint& p) { return p.mean_ratio; });
    budget.stages = median_stages(points);
    if (points.size() > 1) {
        if (const std::optional<double> of_mean = square_of_mean(budget, points.front()->method, options, truth)) {
            const BiasAndNoise parts = split_error(square, above_reference_noise(*of_mean, truth), static_cast<int>(points.size()));
            budget.bias = parts.bias;
            budget.noise = parts.noise;
        }
    }
    return budget;
}

}  // namespace

const std::vector<ErrorMetric>& error_metrics() {
    static const std::vector<ErrorMetric> metrics{{"relative_error", "relative error", &BudgetSummary::relative_error, true},
                                                  {"rmse", "RMSE", &BudgetSummary::rmse, false},
                                                  {"lab_rms", "L*a*b* RMS", &BudgetSummary::lab_rms, false}};
    return metrics;
}

std::vector<MethodSummary> summarise(const std::vector<RunPoint>& points, const ConvergeOptions& options, const Truth& truth) {
    std::vector<std::string> names{path_tracer_name};
    names.insert(names.end(), options.methods.begin(), options.methods.end());
    std::vector<MethodSummary> methods;
    for (const std::string& name : names) {
        std::map<int, Points> budgets;
        for (const RunPoint& point : points)
            if (point.method == name && point.seed < static_cast<std::uint64_t>(options.seeds)) budgets[point.budget].push_back(&point);
        if (budgets.empty()) continue;
        methods.push_back({name, name == path_tracer_name ? path_tracer_summary : find_method(name).summary, {}});
        for (const auto& [budget, runs] : budgets) methods.back().budgets.push_back(summarise_budget(runs, options, truth));
    }
    return methods;
}

Curve curve_of(const MethodSummary& method, const ErrorMetric& metric) {
    std::vector<CurvePoint> points;
    points.reserve(method.budgets.size());
    for (const BudgetSummary& budget : method.budgets) points.push_back({budget.seconds, budget.*metric.value});
    return make_curve(std::move(points));
}

BiasAndNoise split_error(double single_square, double mean_square, int n) {
    const double noise2 = std::max(0.0, (single_square - mean_square) * n / (n - 1));
    return {std::sqrt(std::max(0.0, single_square - noise2)), std::sqrt(noise2)};
}

}  // namespace pencil
