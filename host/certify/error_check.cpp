#include "certify/error_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "certify/emitter_table.h"
#include "certify/film_draws.h"
#include "image/relative_error.h"
#include "pencils/low_discrepancy.h"

namespace pencil {

namespace {

/// Paths of each of the two estimates of a pixel at most, and pixels of one call at least: the more paths at a pixel the less noise, as long as
/// there are pixels enough to know how the error varies.
constexpr int most_paths = 128, least_pixels = 8;
/// Of each pixel on average, from which on pixels are judged one by one.
constexpr std::size_t many_looks = 3;
/// Errors are seldom more than so many times the spread of passes.
constexpr double usual_excess = 4;
/// But what stands out of the check's noise four times counts by half at least: its noise has long tails, and twice of it are no news where hundreds
/// of pixels were looked at.
constexpr double most_doubt = 15;
/// Of the square of how far it stands out: how soon it counts in full, or not at all.
constexpr double sharpness = 4;

/// Mean and its standard error.
struct Mean {
    double value = 0, error = 0;
};
Mean mean_of(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    Mean mean;
    mean.value = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double squares = 0;
    for (const double v : values) squares += (v - mean.value) * (v - mean.value);
    mean.error = std::sqrt(squares / (n * std::max(n - 1, 1.0)));
    return mean;
}

}  // namespace

ErrorCheck::ErrorCheck(RenderContext& context) : context_(context) {
    const EmitterTable table = tabulate_emitters(context.scene, context.flat);
    lights_.count = static_cast<int>(table.emitters.size());
    lights_.densities = Buffer<float>(context.kernels.device(), table.densities, "densities of emitters");
    lights_.sky_density = static_cast<float>(table.sky_density);
    lights_.emitters =
        Buffer<Emitter>(context.kernels.device(), table.emitters.empty() ? std::vector<Emitter>(1) : table.emitters, "emitters");
}

/// Reflected light of pixels, each by so many `paths`.
std::vector<glm::dvec3> ErrorCheck::estimate(const Film& film, const std::vector<std::size_t>& pixels, int paths,
                                             std::uint64_t seed) const {
    const FilmDraws draws(film);
    std::vector<int> starts;
    std::vector<float> weights;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        std::vector<FilmDraws::Draw> drawn = draws.draw(pixels[i], paths, random_unit(seed, 1, i));
        drawn.resize(static_cast<std::size_t>(paths), {-1, 0.0F});
        for (const FilmDraws::Draw& d : drawn) {
            starts.push_back(d.surfel);
            weights.push_back(d.weight);
        }
    }
    const auto& device = context_.kernels.device();
    Buffer<float> radiance(device, 3 * starts.size(), "radiance of check paths");
    trace_checks(context_.kernels, context_.device_scene, film.surfels(), Buffer<int>(device, starts, "starts of check paths"), lights_,
                 context_.options.bounces, static_cast<uint>(hash64(seed) >> 32), radiance);
    const std::vector<float> found = radiance.read();
    std::vector<glm::dvec3> values(pixels.size(), glm::dvec3(0));
    for (std::size_t at = 0; at < starts.size(); ++at)
        values[at / static_cast<std::size_t>(paths)] +=
            static_cast<double>(weights[at]) / paths * glm::dvec3(found[at], found[starts.size() + at], found[2 * starts.size() + at]);
    return values;
}

void ErrorCheck::transfer(Archive& archive, std::size_t pixels) {
    archive(points_, emission_, weight_, half_done_);
    if (!archive.reads()) return;
    Archive::expect(emission_.size() == (weight_ == 0 ? 0 : 3 * pixels), "the emission has another size");
    for (const std::vector<Point>* points : {&points_, &half_done_})
        for (const Point& p : *points) Archive::expect(p.pixel < pixels, "a check lies outside the image");
}

void ErrorCheck::add_emission(const std::vector<float>& emission, double weight) {
    emission_.resize(emission.size(), 0.0);
    for (std::size_t i = 0; i < emission.size(); ++i) emission_[i] += weight * static_cast<double>(emission[i]);
    weight_ += weight;
}

void ErrorCheck::add(const Film& film, int paths, std::uint64_t seed) {
    const int each = std::clamp(paths / (2 * least_pixels), 1, most_paths);
    const auto looked = static_cast<std::size_t>(std::max(paths / (2 * each), least_pixels));
    const glm::dvec2 shift(random_unit(seed, 0, 0), random_unit(seed, 0, 1));
    std::vector<std::size_t> pixels;
    for (const Point& p : half_done_) pixels.push_back(p.pixel);
    for (std::size_t i = 0; i < looked; ++i) {
        const glm::dvec2 u = r2_sequence(i, shift);
        const auto x = static_cast<std::size_t>(u.x * film.width()), y = static_cast<std::size_t>(u.y * film.height());
        pixels.push_back(y * static_cast<std::size_t>(film.width()) + x);
    }
    const std::vector<glm::dvec3> values = estimate(film, pixels, each, seed);
    const std::size_t begin = half_done_.size();
    std::vector<glm::dvec3> second(pixels.size() - begin, glm::dvec3(0));
    if (points_.empty() && begin == 0) second = estimate(film, pixels, each, hash64(seed));  // there is but this film
    for (std::size_t i = 0; i < begin; ++i) points_.push_back({pixels[i], half_done_[i].first, values[i]});
    half_done_.clear();
    for (std::size_t i = begin; i < pixels.size(); ++i) half_done_.push_back({pixels[i], values[i], second[i - begin]});
}

double join_errors(double spread, const CertifiedError& certified) {
    if (certified.points < 2) return spread;
    if (!std::isfinite(spread)) return std::max(certified.relmse, certified.standard_error);
    const double more = std::max(certified.relmse - spread, 0.0);
    // Errors far beyond the spread are rare, and chance is not where the check itself hardly knows: it has to stand out the more.
    const double noise = certified.standard_error * certified.standard_error,
                 doubt = 1 + (spread > 0 ? std::min(certified.standard_error / (usual_excess * spread), most_doubt) : most_doubt);
    return spread + (more * more > 0 ? more / (1 + std::pow(doubt * noise / (more * more), sharpness)) : 0.0);
}

/// All that was looked at, by pixel.
std::vector<PixelLooks> ErrorCheck::looks_at(const std::vector<Point>& points, const std::vector<float>& beauty) const {
    std::vector<PixelLooks> looks(beauty.size() / 3);
    for (const Point& p : points) {
        glm::dvec3 x;
        for (int c = 0; c < 3; ++c) x[c] = reflected(beauty, 3 * p.pixel + static_cast<std::size_t>(c));
        looks[p.pixel].add(x - p.first);
        looks[p.pixel].add(x - p.second);
    }
    return looks;
}

/// What errors are relative to: the mean of the image, or, where it is black, of what paths find.
double ErrorCheck::scale_of(const std::vector<Point>& points, const std::vector<float>& beauty) {
    const double mean = std::accumulate(beauty.begin(), beauty.end(), 0.0) / static_cast<double>(beauty.size());
    if (mean > 0 || !std::isfinite(mean) || points.empty()) return mean;
    double found = 0;
    for (const Point& p : points)
        for (int c = 0; c < 3; ++c) found += (p.first[c] + p.second[c]) / 2;
    return found / (3 * static_cast<double>(points.size()));
}

/// What a value of the beauty holds of reflected light.
double ErrorCheck::reflected(const std::vector<float>& beauty, std::size_t i) const {
    const auto shown = static_cast<double>(beauty[i]);
    return weight_ > 0 ? shown - emission_[i] / weight_ : shown;
}

CertifiedError ErrorCheck::certify(const std::vector<float>& beauty, const std::vector<float>& usual) const {
    CertifiedError error;
    const std::vector<Point>& points = points_.empty() ? half_done_ : points_;
    const double mean = scale_of(points, beauty);
    if (points.size() < 2 || !std::isfinite(mean)) return error;
    error.points = static_cast<int>(points.size());
    if (mean == 0) return error;
    if (points.size() >= many_looks * beauty.size() / 3) return certify_pixels(looks_at(points, beauty), usual, mean);
    std::vector<double> squares, steps;
    for (const Point& p : points) {
        double square = 0, step = 0;
        for (int c = 0; c < 3; ++c) {
            const std::size_t i = 3 * p.pixel + static_cast<std::size_t>(c);
            const double x = reflected(beauty, i);
            square += (x - p.first[c]) * (x - p.second[c]) / relative_to(static_cast<double>(usual[i]), mean) / 3;
            step += (x - 0.5 * (p.first[c] + p.second[c])) / (3 * mean);
        }
        squares.push_back(square);
        steps.push_back(step);
    }
    const Mean square = mean_of(squares), step = mean_of(steps);
    error.relmse = square.value;
    error.standard_error = square.error;
    error.mean_bias = step.value;
    error.mean_error = step.error;
    return error;
}

}  // namespace pencil
