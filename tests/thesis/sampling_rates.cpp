#include "thesis/sampling_rates.h"

namespace pencil::thesis {

namespace {

struct Texel {
    double solid_angle, rate;
};

/// Solid angle weighted mean of value(rate relative to `unit`).
template <typename Value>
double over_sphere(const std::vector<Texel>& texels, double unit, const Value& value) {
    double sum = 0.0, weights = 0.0;
    for (const Texel& t : texels) {
        sum += t.solid_angle * value(t.rate / unit);
        weights += t.solid_angle;
    }
    return sum / weights;
}

/// Largest over smallest local rate at the corners of texels and on the rim, pulled in a little so that cells about them are covered.
double sampling_ratio(const ref::Map& map, int n) {
    constexpr double pull = 0.9995, half_cell = 1e-4;
    double low = HUGE_VAL, high = 0.0;
    const auto visit = [&](const ref::dvec2& point) {
        const ref::dvec2 p = pull * ref::last_covered(map, {0.0, 0.0}, point);
        for (int tile = 0; tile < map.tiles; ++tile) {
            const double rate = 4.0 * half_cell * half_cell / ref::solid_angle(map, tile, p - half_cell, p + half_cell, 1);
            low = std::min(low, rate);
            high = std::max(high, rate);
        }
    };
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) visit({2.0 * x / n - 1.0, 2.0 * y / n - 1.0});
    return high / low;
}

/// Whole texels; `used` becomes the share of area that is covered, counted by texel centres.
std::vector<Texel> whole_texels(const ref::Map& map, int n, double& used) {
    constexpr int segments = 4;
    const double side = 2.0 / n;
    std::vector<Texel> texels;
    int covered = 0;
    for (int tile = 0; tile < map.tiles; ++tile)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                covered += map.covers(ref::texel_centre(x, y, n)) ? 1 : 0;
                const ref::dvec2 low(x * side - 1.0, y * side - 1.0);
                if (!ref::covers_cell(map, low, low + side)) continue;
                const double omega = ref::solid_angle(map, tile, low, low + side, segments);
                texels.push_back({omega, side * side / omega});
            }
    used = covered / (static_cast<double>(map.tiles) * n * n);
    return texels;
}

}  // namespace

SamplingRates sampling_rates(const ref::Map& map, int n) {
    SamplingRates out;
    const std::vector<Texel> texels = whole_texels(map, n, out.used);
    const double mean = over_sphere(texels, 1.0, [](double rate) { return rate; });
    out.ratio = sampling_ratio(map, n);
    out.variation_sphere = std::sqrt(over_sphere(
        texels, mean, [](double r) { return (r - 1.0) * (r - 1.0); }));
    out.deviation = over_sphere(texels, mean, [](double r) { return std::abs(r - 1.0); });
    double sum = 0.0, squares = 0.0;
    for (const Texel& t : texels) {
        sum += t.rate;
        squares += t.rate * t.rate;
    }
    const auto count = static_cast<double>(texels.size());
    out.variation_texels = std::sqrt(std::max(squares / count - sum * sum / (count * count), 0.0)) / (sum / count);
    const auto bins = static_cast<std::size_t>(std::lround(SamplingRates::most / SamplingRates::bin_width));
    out.histogram.assign(bins, 0.0);
    double total = 0.0;
    for (const Texel& t : texels) total += t.solid_angle;
    for (const Texel& t : texels) {
        const auto bin = static_cast<std::size_t>(t.rate / mean / SamplingRates::bin_width);
        out.histogram[std::min(bin, bins - 1)] += t.solid_angle / total;
    }
    return out;
}

}  // namespace pencil::thesis
