#include "converge/methods.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "options/render_option_table.h"

namespace pencil {
namespace {

constexpr double growth = 1.5;  // of the number of pencils from step to step
constexpr int first_pencils = 8;
constexpr double first_seconds = 0.25;  // doubled from step to step

/// A ladder of pencils. Light samples grow with them: with a fixed number, the error of direct light would be a floor of its own.
Budget pencil_budget(int step, RenderOptions base, const std::string& flags) {
    const double most = 1 << 20;
    base.pencils = base.light_samples = static_cast<int>(std::lround(std::min(first_pencils * std::pow(growth, step), most)));
    return {base, fmt::format("--method {2} --pencils {0} --light-samples {0}{1}", base.pencils, flags, to_string(base.method))};
}

MeasuredMethod pencil_method(const std::string& name, const std::string& summary, const RenderOptions& base, const std::string& flags) {
    return {name, summary, [base, flags](int step) { return pencil_budget(step, base, flags); }};
}

/// A ladder of time.
Budget surface_budget(int step) {
    RenderOptions options;
    options.method = MethodName::surface;
    options.seconds = first_seconds * std::exp2(step);
    return {options, fmt::format("--method surface --time {:g}", options.seconds)};
}

std::vector<MeasuredMethod> make_methods() {
    RenderOptions standard;
    standard.method = MethodName::line;
    RenderOptions fixed = standard, voronoi = standard, analytic = standard, thesis = standard, hybrid = standard;
    fixed.iterate = Iterate::fixed;
    voronoi.weights = Weights::voronoi;
    analytic.weights = Weights::analytic;
    thesis.weights = Weights::thesis;
    hybrid.method = MethodName::hybrid;
    return {
        pencil_method("sets", "a new, smaller set of pencils for each bounce, consistent weights (pencil render --method line)", standard,
                      ""),
        pencil_method("fixed", "one set of pencils for all bounces, consistent weights", fixed, " --iterate fixed"),
        pencil_method("voronoi", "a new, smaller set for each bounce, weights by Voronoi cells of directions", voronoi,
                      " --weights voronoi"),
        pencil_method("analytic", "a new, smaller set for each bounce, weights by the free path", analytic, " --weights analytic"),
        pencil_method("thesis", "a new, smaller set for each bounce, weights with the normaliser printed in the thesis", thesis,
                      " --weights thesis"),
        pencil_method("hybrid", "lines through pencils and rays of the surfels, weighted by power cells (pencil render --method hybrid)",
                      hybrid, ""),
        {"surface", "pencils on surfaces gather indirect light for the film and for each other (the default of pencil render)",
         surface_budget}};
}

}  // namespace

const char* const path_tracer_name = "path-tracer";
const char* const path_tracer_summary = "the reference path tracer (pencil reference), the baseline";

const std::vector<MeasuredMethod>& all_methods() {
    static const std::vector<MeasuredMethod> methods = make_methods();
    return methods;
}

std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const MeasuredMethod& method : all_methods()) names.push_back(method.name);
    return names;
}

const MeasuredMethod& find_method(const std::string& name) {
    const std::vector<MeasuredMethod>& methods = all_methods();
    const auto found = std::find_if(methods.begin(), methods.end(), [&](const MeasuredMethod& method) { return method.name == name; });
    if (found == methods.end()) throw std::invalid_argument(fmt::format("unknown method {}", name));
    return *found;
}

double path_tracer_seconds(int step) {
    const std::array<double, 2> mantissas{0.03, 0.1};
    return mantissas[static_cast<std::size_t>(step % 2)] * std::pow(10.0, step / 2);
}

}  // namespace pencil
