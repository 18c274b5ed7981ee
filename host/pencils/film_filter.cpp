#include "pencils/film_filter.h"

#include <algorithm>
#include <cmath>

#include "pencils/low_discrepancy.h"

namespace pencil {

namespace {

constexpr double pi = 3.14159265358979323846;

double sinc(double x) { return x == 0 ? 1.0 : std::sin(pi * x) / (pi * x); }

/// Mitchell and Netravali 1988, on [-2, 2].
double mitchell(double x, double b, double c) {
    x = std::abs(x);
    if (x < 1) return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + (6 - 2 * b)) / 6;
    if (x < 2) return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x + (8 * b + 24 * c)) / 6;
    return 0;
}

}  // namespace

double filter_value(const ReconstructionFilter& f, double x) {
    const double a = std::abs(x);
    using Kind = ReconstructionFilter::Kind;
    if (f.kind == Kind::box) return x >= -f.radius && x < f.radius ? 1.0 : 0.0;
    if (a > f.radius) return 0.0;
    switch (f.kind) {
        case Kind::tent:
            return std::max(1.0 - a / f.radius, 0.0);
        case Kind::gaussian: {
            const double alpha = -0.5 / (f.stddev * f.stddev);
            return std::max(std::exp(alpha * a * a) - std::exp(alpha * f.radius * f.radius), 0.0);
        }
        case Kind::mitchell:
            return mitchell(2 * a / f.radius, f.b, f.c);
        case Kind::catmullrom:
            return mitchell(2 * a / f.radius, 0.0, 0.5);
        case Kind::lanczos:
            return sinc(a) * sinc(a / f.radius);
        default:
            return 0.0;
    }
}

std::vector<glm::vec2> film_sample_offsets(int samples, std::uint64_t seed) {
    const glm::dvec2 shift(random_unit(seed, 101, 0), random_unit(seed, 102, 0));
    std::vector<glm::vec2> offsets;
    offsets.reserve(static_cast<std::size_t>(samples));
    for (int i = 0; i < samples; ++i)
        offsets.emplace_back(glm::min(glm::vec2(r2_sequence(static_cast<std::uint64_t>(i), shift)), glm::vec2(0.99999994F)));
    return offsets;
}

FilterTable tabulate_filter(const ReconstructionFilter& filter, const std::vector<glm::vec2>& offsets) {
    FilterTable table;
    table.reach = std::max(static_cast<int>(std::ceil(filter.radius - 0.5)), 0);
    for (int dy = -table.reach; dy <= table.reach; ++dy)
        for (int dx = -table.reach; dx <= table.reach; ++dx) {
            double total = 0;
            for (const glm::vec2& o : offsets) {
                const double w =
                    filter_value(filter, dx + static_cast<double>(o.x) - 0.5) * filter_value(filter, dy + static_cast<double>(o.y) - 0.5);
                table.weights.push_back(static_cast<float>(w));
                total += w;
            }
            table.totals.push_back(static_cast<float>(total));
        }
    return table;
}

}  // namespace pencil
