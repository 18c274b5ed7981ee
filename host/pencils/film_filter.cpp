#include "pencils/film_filter.h"

#include <algorithm>
#include <cmath>

#include "pencils/low_discrepancy.h"
#include "scene/filter_value.h"

namespace pencil {

std::vector<glm::vec2> film_sample_offsets(int samples, std::uint64_t seed, std::uint64_t turn) {
    const glm::dvec2 shift(random_unit(seed, 101, 0), random_unit(seed, 102, 0));
    std::vector<glm::vec2> offsets;
    offsets.reserve(static_cast<std::size_t>(samples));
    const auto count = static_cast<std::uint64_t>(samples);
    for (std::uint64_t i = turn * count; i < (turn + 1) * count; ++i)
        offsets.emplace_back(glm::min(glm::vec2(r2_sequence(i, shift)), glm::vec2(0.99999994F)));
    return offsets;
}

std::vector<glm::vec2> lens_points(int samples, std::uint64_t seed, std::uint64_t turn) {
    const glm::dvec2 shift(random_unit(seed, 103, 0), random_unit(seed, 104, 0));
    const auto count = static_cast<std::uint64_t>(samples);
    std::vector<glm::vec2> points;
    for (std::uint64_t i = turn * count; i < (turn + 1) * count; ++i) {
        const glm::dvec2 u = r2_sequence(i, shift);
        const double radius = std::sqrt(u.x), angle = 2 * 3.14159265358979323846 * u.y;
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    // Sample k of a pixel shall not see a point of the lens that goes with its place in the pixel.
    std::uint64_t bits = hash64(seed ^ hash64(turn + 1));
    for (std::size_t i = points.size(); i > 1; --i, bits = hash64(bits)) std::swap(points[i - 1], points[bits % i]);
    return points;
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
