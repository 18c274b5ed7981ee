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
