#include "film/layer_mean.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "film/outliers.h"
#include "image/relative_error.h"

namespace pencil {

double student(int values) {
    constexpr std::array<double, 3> few{6.48, 2.20, 1.62};
    const int freedom = std::max(values - 1, 1);
    if (freedom <= static_cast<int>(few.size())) return few[static_cast<std::size_t>(freedom) - 1];
    return 1 + 1.21 / freedom + 1.6 / (static_cast<double>(freedom) * freedom);
}

void LayerMean::Sum::add(const std::vector<float>& beauty, const std::vector<float>& first, double image_weight) {
    if (value.empty()) value.assign(first.size(), 0.0F);
    weight += image_weight;
    for (std::size_t i = 0; i < first.size(); ++i)
        value[i] += static_cast<float>(image_weight * (static_cast<double>(beauty[i]) - static_cast<double>(first[i])));
}

void LayerMean::add(std::vector<Layer> layers, double weight, int generation, int set) {
    if (count_ == 0) first_ = layers.front().pixels;
    if (generation != generation_) begin_generation(generation);
    const auto sequence = static_cast<std::size_t>(count_ % sequences);
    of_[sequence].add(layers.front().pixels, first_, weight);
    now_[sequence % 2].add(layers.front().pixels, first_, weight);
    if (set >= 0) of_set_[static_cast<std::size_t>(set) % of_set_.size()].add(layers.front().pixels, first_, weight);
    weights_.back() += weight;
    weight_ += weight;
    if (count_++ == 0) {
        mean_ = std::move(layers);
        return;
    }
    for (std::size_t l = 0; l < layers.size(); ++l)
        Archive::expect(l < mean_.size() && layers[l].pixels.size() == mean_[l].pixels.size(), "images of one mean have other layers");
    const double share = weight / weight_;
    for (std::size_t l = 0; l < layers.size(); ++l)
        for (std::size_t i = 0; i < mean_[l].pixels.size(); ++i)
            mean_[l].pixels[i] +=
                static_cast<float>(share * (static_cast<double>(layers[l].pixels[i]) - static_cast<double>(mean_[l].pixels[i])));
}

bool LayerMean::has_sets() const {
    return std::all_of(
        of_set_.begin(), of_set_.end(), [](const Sum& s) { return s.weight > 0; });
}

void LayerMean::spread_outliers(int width) {
    if (!has_sets()) return;
    std::vector<ImageValues> images(of_set_.size(), first_);
    for (std::size_t s = 0; s < of_set_.size(); ++s)
        for (std::size_t i = 0; i < first_.size(); ++i)
            images[s][i] += static_cast<float>(static_cast<double>(of_set_[s].value[i]) / of_set_[s].weight);
    const SpreadOutliers spread = pencil::spread_outliers(images, width);
    ImageValues steps(first_.size());
    for (std::size_t s = 0; s < of_set_.size(); ++s)
        for (std::size_t i = 0; i < first_.size(); ++i) {
            steps[i] += static_cast<float>(of_set_[s].weight / weight_) * spread.steps[s][i];
            of_set_[s].value[i] += static_cast<float>(of_set_[s].weight) * spread.steps[s][i];
        }
    for (Layer& layer : mean_) {
        if (&layer != &mean_.front() && layer.name != indirect_layer) continue;
        for (std::size_t i = 0; i < first_.size(); ++i) layer.pixels[i] += steps[i];
    }
    for (Sum& s : of_) settle(s, spread.limits, steps);
    for (Halves* halves : {&now_, &before_})
        for (Sum& s : *halves) settle(s, spread.limits, steps);
}

/// A sum of images that were spread by sets, not by what it sums: outliers become what the mean shows now, the others get its steps.
void LayerMean::settle(Sum& sum, const std::vector<float>& limits, const std::vector<float>& steps) const {
    if (sum.weight == 0) return;
    for (std::size_t i = 0; i < first_.size(); ++i) {
        const double shown = static_cast<double>(mean_.front().pixels[i]) - static_cast<double>(first_[i]);
        if (std::isinf(limits[i / 3]))
            sum.value[i] += static_cast<float>(sum.weight) * steps[i];
        else
            sum.value[i] = static_cast<float>(sum.weight * shown);
    }
}

/// Mean over the beauty's values of square(i), relative as in relMSE.
template <typename Square>
double LayerMean::relative_mean(Square square) const {
    const std::vector<float>& pixels = mean_.front().pixels;
    const double mean = std::accumulate(pixels.begin(), pixels.end(), 0.0) / static_cast<double>(pixels.size());
    if (mean <= 0) return 0;
    double sum = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) sum += square(i) / relative_to(usual(i), mean);
    return sum / static_cast<double>(pixels.size());
}

/// A value of the beauty, or, where one of the sequences shows more than twice what the others do, what these show: a rare event that makes a
/// value wrong is not to hide how wrong it is beside the truth.
double LayerMean::usual(std::size_t i) const {
    const auto shown = static_cast<double>(mean_.front().pixels[i]);
    if (!has_sets()) return shown;
    double sum = 0, highest = 0;
    for (const Sum& s : of_) {
        const double value = static_cast<double>(first_[i]) + static_cast<double>(s.value[i]) / s.weight;
        sum += value;
        highest = std::max(highest, value);
    }
    const double others = (sum - highest) / (sequences - 1);
    return highest > 2 * others ? std::min(std::max(others, 0.0), shown) : shown;
}

std::vector<float> LayerMean::usual_values() const {
    std::vector<float> values(first_.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(usual(i));
    return values;
}

void LayerMean::begin_generation(int generation) {
    last_square_ = shared_square();
    before_ = std::move(now_);
    now_ = Halves();
    weights_.push_back(0.0);
    generation_ = generation;
}

/// Square of the error that the images of this generation share. The halves are independent but for such errors: the product of their steps
/// from the last generation is free of noise in the mean. It is three times that square if generations err independently and the square
/// halves from each to the next; where they err alike, and errors of interpolation do, it is less.
double LayerMean::shared_square() const {
    const double expected = 0.5 * last_square_;
    for (std::size_t half = 0; half < 2; ++half)  // steps to the first images of a generation hold little but noise
        if (before_[half].weight == 0 || now_[half].weight < before_[half].weight) return expected;
    const auto step = [&](std::size_t half, std::size_t i) {
        return static_cast<double>(now_[half].value[i]) / now_[half].weight -
               static_cast<double>(before_[half].value[i]) / before_[half].weight;
    };
    const double square = relative_mean([&](std::size_t i) { return step(0, i) * step(1, i); }) / 3.0;
    return std::max(square, 0.5 * expected);  // noise may hide it
}

/// sum(W^2 (M - mean)^2) / sum(W)^2 over the means M of the sequences and their weights W, right whatever their variances are (White 1980),
/// times what makes it unbiased where variances are as 1 / W: sum(W) / (sum(W) - W) for each.
double LayerMean::variance_of_mean(const Sums& sums, std::size_t i) const {
    const double mean = static_cast<double>(mean_.front().pixels[i]) - static_cast<double>(first_[i]);
    double sum = 0;
    for (const Sum& s : sums) {
        if (s.weight == 0) continue;
        const double step = static_cast<double>(s.value[i]) - s.weight * mean;
        sum += step * step / (1.0 - s.weight / weight_);
    }
    return sum / (weight_ * weight_);
}

/// By the sequences, or, where there are sets, by these if they differ more: each of them lies in all sequences.
double LayerMean::mean_square_noise() const {
    const double noise = relative_mean([&](std::size_t i) { return variance_of_mean(of_, i); });
    return has_sets() ? std::max(noise, relative_mean([&](std::size_t i) { return variance_of_mean(of_set_, i); })) : noise;
}

std::vector<unsigned char> LayerMean::noisy_pixels(double times) const {
    const std::size_t pixels = first_.size() / 3;
    if (count_ < 2) return {};
    const std::vector<float>& shown = mean_.front().pixels;
    const double mean = std::accumulate(shown.begin(), shown.end(), 0.0) / static_cast<double>(shown.size());
    std::vector<double> plain(pixels), relative(pixels);
    for (std::size_t i = 0; i < 3 * pixels; ++i) {
        const double variance = variance_of_mean(of_, i);
        plain[i / 3] += variance;
        relative[i / 3] += mean > 0 ? variance / relative_to(usual(i), mean) : 0;
    }
    std::vector<unsigned char> noisy(pixels);
    for (const std::vector<double>* noise : {&plain, &relative}) {
        const double limit = times * std::accumulate(noise->begin(), noise->end(), 0.0) / static_cast<double>(pixels);
        for (std::size_t p = 0; p < pixels; ++p)
            if ((*noise)[p] > limit) noisy[p] = 1;
    }
    return std::any_of(noisy.begin(), noisy.end(), [](unsigned char n) { return n != 0; }) ? noisy : std::vector<unsigned char>();
}

/// What the mean keeps of that if all generations err alike. Independence in shared_square and likeness here lie on either side of the
/// truth: together they fit the scenes that were measured (docs/accuracy.md).
double LayerMean::shared_square_error() const {
    double sum = 0, growth = 1;
    for (std::size_t g = weights_.size(); g-- > 0; growth *= std::sqrt(2.0)) sum += weights_[g] / weight_ * growth;
    return sum * sum * shared_square();
}

double LayerMean::relative_mean_square_error() const {
    if (count_ < 2) return std::numeric_limits<double>::infinity();
    return mean_square_noise() + shared_square_error();
}

void LayerMean::append_error(std::vector<Layer>& layers) const {
    if (count_ < 2) return;
    const double noise = mean_square_noise(), scale = noise > 0 ? std::sqrt(1.0 + shared_square_error() / noise) : 1.0;
    Layer error{error_layer, 3, std::vector<float>(first_.size())};
    for (std::size_t i = 0; i < first_.size(); ++i) error.pixels[i] = static_cast<float>(scale * std::sqrt(variance_of_mean(of_, i)));
    layers.push_back(std::move(error));
}

void LayerMean::transfer(Archive& archive, std::size_t pixels) {
    archive(count_, weight_, mean_, first_, of_, of_set_, generation_, weights_, now_, before_, last_square_);
    if (!archive.reads()) return;
    for (const Layer& layer : mean_)
        Archive::expect(layer.channels > 0 && layer.pixels.size() == pixels * static_cast<std::size_t>(layer.channels),
                        "a layer has another size");
    Archive::expect(count_ >= 0 && (count_ > 0) == !mean_.empty() && !weights_.empty(), "no mean of images");
    Archive::expect(mean_.empty() ? first_.empty() : mean_.front().pixels.size() == first_.size() && first_.size() == 3 * pixels,
                    "no beauty");
    Archive::expect(mean_.empty() || mean_.front().channels == 3, "the beauty has no colours");
    const auto check = [&](const Sum& sum) {
        Archive::expect(std::isfinite(sum.weight) && sum.weight >= 0, "a weight is none");
        Archive::expect(sum.value.size() == (sum.weight == 0 ? 0 : first_.size()), "a sum of images has another size");
    };
    for (const Sums* sums : {&of_, &of_set_}) std::for_each(sums->begin(), sums->end(), check);
    for (const Halves* halves : {&now_, &before_}) std::for_each(halves->begin(), halves->end(), check);
    for (int s = 0; s < sequences; ++s)
        Archive::expect((of_[static_cast<std::size_t>(s)].weight > 0) == (s < count_), "a sequence has no images");
    Archive::expect(!has_sets() || count_ >= sequences, "there are fewer images than sets");
    Archive::expect(std::isfinite(weight_) && (weight_ > 0) == (count_ > 0), "the mean has no weight");
}

std::vector<Layer> LayerMean::take() {
    append_error(mean_);
    count_ = 0;
    return std::move(mean_);
}

}  // namespace pencil
