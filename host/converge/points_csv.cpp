// points.csv. Numbers have as many digits as tell them apart.
#include <fmt/format.h>

#include "converge/run_fields.h"
#include "util/format.h"

namespace pencil {
namespace {

/// "film geometry=0.01;direct light=0.2"
std::string join_stages(const RunPoint& point) {
    std::string text;
    for (const auto& [name, seconds] : point.stages) text += fmt::format("{}{}={}", text.empty() ? "" : ";", name, seconds);
    return text;
}

}  // namespace

std::string points_csv(const std::vector<RunPoint>& points) {
    std::string text = "method,budget,seed";
    for (const RunField& field : run_fields) text += fmt::format(",{}", field.key);
    text += ",excluded_pixels,load,options,stages\n";
    for (const RunPoint& point : points) {
        text += fmt::format("{},{},{}", point.method, point.budget, point.seed);
        for (const RunField& field : run_fields) text += fmt::format(",{}", point.*field.value);
        text += fmt::format(",{},{},{},{}\n", point.excluded_pixels, point.load, csv_quoted(point.options), csv_quoted(join_stages(point)));
    }
    return text;
}

}  // namespace pencil
