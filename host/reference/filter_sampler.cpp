#include "reference/filter_sampler.h"

#include <algorithm>
#include <cmath>

#include "scene/filter_value.h"

namespace pencil {
namespace {

constexpr int cells_per_pixel = 64;  // even, so that the borders of pixels are borders of cells
constexpr double cell_width = 1.0 / cells_per_pixel;

}  // namespace

FilterSampler::FilterSampler(const ReconstructionFilter& filter) {
    const int half = static_cast<int>(std::ceil(filter.radius * cells_per_pixel));
    radius_ = half * cell_width;
    integral_.push_back(0);
    double magnitude = 0;
    for (int i = -half; i < half; ++i) {
        const double start = std::max(i * cell_width, -filter.radius), end = std::min((i + 1) * cell_width, filter.radius);
        const double width = end - start, inset = 1e-9 * width;  // just inside, where a box that ends here still has its value
        const double left = filter_value(filter, start + inset), right = filter_value(filter, end - inset);
        const double density = 0.5 * (std::abs(left) + std::abs(right)), inverse = density > 0 ? 1 / density : 0;
        const double from = magnitude;
        magnitude += density * width;
        cells_.push_back({start, width, from, magnitude, inverse / width, left * inverse, (right - left) * inverse});
        integral_.push_back(integral_.back() + 0.5 * (left + right) * width);
    }
    guide_.resize(cells_.size());
    for (std::size_t part = 0, i = 0; part < guide_.size(); ++part) {
        while (cells_[i].to <= static_cast<double>(part) / static_cast<double>(guide_.size()) * magnitude) ++i;
        guide_[part] = i;
    }
}

std::size_t FilterSampler::cells_before(double x) const {
    const double count = std::round((x + radius_) * cells_per_pixel);
    return static_cast<std::size_t>(std::clamp(count, 0.0, static_cast<double>(cells_.size())));
}

FilterSampler::Range FilterSampler::range(double low, double high) const {
    const std::size_t first = cells_before(low), end = cells_before(high);
    const double from = cells_[first].from, to = cells_[end - 1].to;
    return {from, to, (to - from) / (integral_[end] - integral_[first])};
}

FilterSampler::Sample FilterSampler::sample(const Range& range, double u) const {
    const double target = range.from + u * (range.to - range.from);
    const auto part = static_cast<std::size_t>(target / cells_.back().to * static_cast<double>(guide_.size()));
    std::size_t i = guide_[std::min(part, guide_.size() - 1)];
    while (i + 1 < cells_.size() && cells_[i].to <= target) ++i;
    const Cell& cell = cells_[i];
    const double inside = std::clamp((target - cell.from) * cell.inverse, 0.0, 1.0);
    return {cell.start + inside * cell.width, static_cast<float>((cell.left + cell.slope * inside) * range.scale)};
}

}  // namespace pencil
