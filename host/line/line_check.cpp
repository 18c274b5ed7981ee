#include "line/line_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtx/component_wise.hpp>

#include "certify/error_check.h"
#include "pencils/low_discrepancy.h"
#include "util/error.h"

namespace pencil {

namespace {

/// Paths of a check: some percent of the time of a usual set of pencils. Fewer where each is long; none where most would be cut
/// (trace_checks.cl).
constexpr int most_paths = 65536;
constexpr double usual_length = 50, longest = 200;  // [reflections]
/// A mean is surely wrong where it is off by more than so many standard errors of the check, and worth a warning where it is by more than this share.
constexpr double sure_errors = 3, least_bias = 0.05;

}  // namespace

bool LineCheck::wanted(const RenderOptions& options, bool maps_emit) {
    return !options.field && !options.keep_field && !options.thin && options.bounces != 0 && (options.bounces != 1 || maps_emit);
}

void LineCheck::end(RenderContext& context, const Frame& frame, const BounceSeries& series) {
    const int bounces = context.options.bounces;
    const double endless = 1 / std::max(1 - glm::compMax(series.ratio()), 1e-9),
                 length = bounces < 0 ? endless : std::min<double>(bounces, endless);
    if (bounces < 0 && series.diverges())
        left_out_ = "left out: check by light paths (the series has no sum)";
    else if (length > longest)
        left_out_ = "left out: check by light paths (too many reflections matter)";
    else
        try {
            context.clock.run(
                "check error", [&] { look(context, frame, length); });
        } catch (const MemoryError& error) {  // the image is whole
            left_out_ = std::string("left out: check by light paths (") + error.what() + ")";
        } catch (const DeviceError& error) {
            left_out_ = std::string("left out: check by light paths (") + error.what() + ")";
        }
}

void LineCheck::look(RenderContext& context, const Frame& frame, double length) {
    ErrorCheck check(context);
    check.add_emission(emission_, 1);
    check.add(frame.film(), static_cast<int>(most_paths / std::max(length / usual_length, 1.0)), hash64(context.options.seed + 1));
    found_ = check.certify(frame.layers().beauty(), frame.layers().beauty());
    if (found_.points < 2 || std::abs(found_.mean_bias) <= std::max(sure_errors * found_.mean_error, least_bias)) return;
    context.stats.warnings.push_back(
        fmt::format("light paths find the image's mean wrong by {:+.1f} %, give or take {:.1f} %: take more --pencils, or --method {}",
                    100 * found_.mean_bias, 100 * interval_errors * found_.mean_error,
                    context.options.method == MethodName::line ? "hybrid or surface" : "surface"));
}

}  // namespace pencil
