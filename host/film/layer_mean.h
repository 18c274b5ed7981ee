// Weighted mean of images of the same scene, and what the spread among them says about its error.
#pragma once

#include <array>
#include <vector>

#include "options/layer.h"
#include "util/archive.h"

namespace pencil {

class LayerMean {
public:
    /// Images come from so many sequences in turn. Those of one sequence may continue each other's samples, so that their mean is better
    /// than that of independent images; the sequences are independent of each other.
    static constexpr int sequences = 4;

    /// Adds an image with its weight in the mean. Later images have the layers of the first, or the first of them: the others stay as they
    /// are. Images of one `generation`, which never falls, may share an error that no sequence shows, and so may those of one `set`, of which there
    /// are four kinds in turn; -1: sets are not looked at, and outliers are not to be spread.
    void add(std::vector<Layer> layers, double weight, int generation, int set = -1);

    /// Spreads what only one of the four kinds of sets shows of a pixel, in the beauty and in its indirect light (outliers.h). Does nothing
    /// before there are as many.
    void spread_outliers(int width);

    int count() const { return count_; }
    const std::vector<float>& beauty() const { return mean_.front().pixels; }
    /// What errors of the beauty's values are relative to: these, but for what only one of the sequences shows.
    std::vector<float> usual_values() const;

    /// Estimated relative mean square error of the mean beauty, relMSE: the variance of the mean over its square, from the spread of the
    /// sequences, and what generations share, from the step between the last two. Needs two images; infinite before.
    double relative_mean_square_error() const;

    /// The part of it that the spread of the sequences shows.
    double mean_square_noise() const;

    /// Per pixel, 1 where that or the noise of the mean of all pixels is so many times what it is on the average; empty if nowhere.
    std::vector<unsigned char> noisy_pixels(double times) const;

    /// The layers of the mean; with two images or more a layer "error" follows: the estimated error of every beauty value. Leaves nothing
    /// behind.
    std::vector<Layer> take();

    /// All of it; ArchiveError unless it is a mean of images of `pixels` pixels.
    void transfer(Archive& archive, std::size_t pixels);

private:
    /// Sum of some images: their weight, and weight * beauty, beauty less the first image's.
    struct Sum {
        double weight = 0;
        std::vector<float> value;
        void add(const std::vector<float>& beauty, const std::vector<float>& first, double image_weight);
        void transfer(Archive& archive) { archive(weight, value); }
    };
    using Sums = std::array<Sum, sequences>;
    using Halves = std::array<Sum, 2>;  // even and odd sequences

    void begin_generation(int generation);
    bool has_sets() const;
    void settle(Sum& sum, const std::vector<float>& limits, const std::vector<float>& steps) const;
    double variance_of_mean(const Sums& sums, std::size_t i) const;
    double shared_square() const;
    double shared_square_error() const;
    void append_error(std::vector<Layer>& layers) const;
    template <typename Square>
    double relative_mean(Square square) const;
    double usual(std::size_t i) const;

    int count_ = 0;
    double weight_ = 0;
    std::vector<Layer> mean_;
    std::vector<float> first_;  // beauty of the first image
    Sums of_, of_set_;          // of the sequences; of the kinds of sets
    int generation_ = 0;
    std::vector<double> weights_{0.0};  // of the generations
    Halves now_, before_;               // of the generation and the last
    double last_square_ = 0;            // shared_square() of the last
};

/// How much wider the interval of a mean is, whose spread is known from so many `values`, than the one of known spread: Student's, 95 %. Few
/// agree by chance too often.
double student(int values);

}  // namespace pencil
