#include "film/outliers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pencil {

namespace {

/// More than so many times what the others show of it or its neighbours, and what all show about it, is an outlier.
constexpr double far_above = 2;
/// Reach of the neighbours: edges of what is bright lie within it. And of what is about a pixel.
constexpr int neighbours = 1, about = 4;
/// Root mean square of what pixels get from one, in terms of their noise: windows grow until it is less; and at most, in the widest one.
constexpr double within_noise = 0.25, most_noise = 1;
/// The noise of a pixel counts as that of those about it, but as no more than so many times what the pixel itself shows, as squares.
constexpr double most_own = 4;
/// Where a greater share of the pixels about are outliers, they are what there is: noise.
constexpr double most_outliers = 0.2;

struct Window {
    int x0, y0, x1, y1;  // up to and without x1, y1
    int size() const { return (x1 - x0) * (y1 - y0); }
};

/// A table of pixels, and of sums over all to the left and above: of values of very different size, the small ones last.
class Table {
public:
    Table(int width, int height)
        : width_(width), values_((static_cast<std::size_t>(width) + 1) * (static_cast<std::size_t>(height) + 1), 0.0L) {}
    long double& at(int x, int y) { return values_[index(x, y)]; }
    long double at(int x, int y) const { return values_[index(x, y)]; }
    /// Adds to all pixels of a window, once sum_up() was called.
    void add(const Window& w, long double value) {
        at(w.x0, w.y0) += value;
        at(w.x1, w.y0) -= value;
        at(w.x0, w.y1) -= value;
        at(w.x1, w.y1) += value;
    }
    void sum_up() {
        const int height = static_cast<int>(values_.size()) / (width_ + 1) - 1;
        for (int y = 0; y <= height; ++y)
            for (int x = 0; x <= width_; ++x) {
                long double& sum = at(x, y);
                if (x > 0) sum += at(x - 1, y);
                if (y > 0) sum += at(x, y - 1);
                if (x > 0 && y > 0) sum -= at(x - 1, y - 1);
            }
    }

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * (static_cast<std::size_t>(width_) + 1) + static_cast<std::size_t>(x);
    }

    int width_;
    std::vector<long double> values_;
};

/// Sums over windows of one value for each pixel.
class WindowSums {
public:
    WindowSums(const std::vector<double>& values, int width) : sums_(width, static_cast<int>(values.size()) / width) {
        for (std::size_t i = 0; i < values.size(); ++i)
            sums_.at(static_cast<int>(i) % width + 1, static_cast<int>(i) / width + 1) = values[i];
        sums_.sum_up();
    }
    double over(const Window& w) const {
        return static_cast<double>(sums_.at(w.x1, w.y1) - sums_.at(w.x0, w.y1) - sums_.at(w.x1, w.y0) + sums_.at(w.x0, w.y0));
    }

private:
    Table sums_;
};

class Outliers {
public:
    Outliers(const std::vector<ImageValues>& images, int width)
        : images_(images),
          width_(width),
          pixels_(images.front().size() / 3),
          highest_(pixels_),
          rest_(pixels_),
          limit_(pixels_),
          square_(pixels_) {
        std::vector<double> means(pixels_);
        for (std::size_t i = 0; i < pixels_; ++i) look_at(i, means[i]);
        const WindowSums sums(means, width);
        for (std::size_t i = 0; i < pixels_; ++i) limit(i, sums);
        compare();
    }

    SpreadOutliers spread() const {
        SpreadOutliers result{std::vector<ImageValues>(images_.size()),
                              std::vector<float>(pixels_, std::numeric_limits<float>::infinity())};
        std::vector<ImageValues>& steps = result.steps;
        const WindowSums squares(square_, width_);
        for (std::size_t image = 0; image < images_.size(); ++image) {
            steps[image].assign(3 * pixels_, 0.0F);
            std::array<Table, 3> parts{Table(width_, height()), Table(width_, height()), Table(width_, height())};
            bool any = false;
            for (std::size_t i = 0; i < pixels_; ++i)
                if (highest_[i] == image && shown(image, i) > limit_[i] && take(image, i, squares, steps[image], parts)) {
                    result.limits[i] = static_cast<float>(limit_[i]);
                    any = true;
                }
            if (any) give(parts, steps[image]);
        }
        return result;
    }

private:
    int height() const { return static_cast<int>(pixels_) / width_; }
    double shown(std::size_t image, std::size_t i) const {
        const float* rgb = &images_[image][3 * i];
        return static_cast<double>(rgb[0]) + static_cast<double>(rgb[1]) + static_cast<double>(rgb[2]);
    }

    Window window(std::size_t i, int reach) const {
        const int x = static_cast<int>(i) % width_, y = static_cast<int>(i) / width_;
        return {std::max(x - reach, 0), std::max(y - reach, 0), std::min(x + reach + 1, width_), std::min(y + reach + 1, height())};
    }

    void look_at(std::size_t i, double& mean) {
        double sum = 0;
        for (std::size_t image = 0; image < images_.size(); ++image) {
            sum += shown(image, i);
            if (shown(image, i) > shown(highest_[i], i)) highest_[i] = image;
        }
        mean = sum / static_cast<double>(images_.size());
        rest_[i] = (sum - shown(highest_[i], i)) / static_cast<double>(images_.size() - 1);
    }

    /// What a pixel may show, and the noise of what keeps to that.
    void limit(std::size_t i, const WindowSums& means) {
        const Window near = window(i, neighbours), wide = window(i, about);
        double most = means.over(wide) / wide.size();
        for (int y = near.y0; y < near.y1; ++y)
            for (int x = near.x0; x < near.x1; ++x)
                most = std::max(most, rest_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)]);
        limit_[i] = far_above * std::max(most, 0.0);
        double sum = 0, squares = 0, count = 0;
        for (std::size_t image = 0; image < images_.size(); ++image) {
            const double value = shown(image, i);
            if (value > limit_[i]) continue;
            sum += value - rest_[i];
            squares += (value - rest_[i]) * (value - rest_[i]);
            ++count;
        }
        square_[i] = count > 1 ? std::max(squares - sum * sum / count, 0.0) / (count - 1) : 0.0;
    }

    /// The noise of one pixel is hardly known, or rare itself: that of those about it counts, as a geometric mean. Where many are outliers none is.
    void compare() {
        std::vector<double> logs(pixels_), noisy(pixels_), outliers(pixels_);
        for (std::size_t i = 0; i < pixels_; ++i) {
            noisy[i] = square_[i] > 0 ? 1 : 0;
            logs[i] = square_[i] > 0 ? std::log(square_[i]) : 0;
            outliers[i] = shown(highest_[i], i) > limit_[i] ? 1 : 0;
        }
        const WindowSums log_sums(logs, width_), noisy_sums(noisy, width_), outlier_sums(outliers, width_);
        for (std::size_t i = 0; i < pixels_; ++i) {
            const Window w = window(i, about);
            if (square_[i] > 0) square_[i] = std::min(most_own * square_[i], std::exp(log_sums.over(w) / noisy_sums.over(w)));
            if (outlier_sums.over(w) > most_outliers * w.size()) limit_[i] = std::numeric_limits<double>::infinity();
        }
    }

    /// Takes what is too much from a pixel, and notes where it goes: in proportion to the square of the noise, which is the least change in terms
    /// of it. False where all noise is too small to hide it.
    bool take(std::size_t image, std::size_t i, const WindowSums& squares, ImageValues& steps, std::array<Table, 3>& parts) const {
        const double all = shown(image, i), share = 1 - limit_[i] / all, excess = share * all;
        const auto is_more_than = [&](double noises, const Window& w, double sum) {
            return excess * excess > noises * noises * w.size() * sum;
        };
        Window w = window(i, 1);
        double sum = squares.over(w);
        for (int reach = 2; is_more_than(within_noise, w, sum) && w.size() < static_cast<int>(pixels_); reach *= 2) {
            w = window(i, reach);
            sum = squares.over(w);
        }
        if (is_more_than(most_noise, w, sum)) return false;
        for (std::size_t c = 0; c < 3; ++c) {
            const double part = share * static_cast<double>(images_[image][3 * i + c]);
            steps[3 * i + c] -= static_cast<float>(part);
            parts[c].add(w, part / sum);
        }
        return true;
    }

    void give(std::array<Table, 3>& parts, ImageValues& steps) const {
        for (std::size_t c = 0; c < 3; ++c) {
            parts[c].sum_up();
            for (std::size_t i = 0; i < pixels_; ++i)
                steps[3 * i + c] += static_cast<float>(
                    square_[i] * static_cast<double>(parts[c].at(static_cast<int>(i) % width_, static_cast<int>(i) / width_)));
        }
    }

    const std::vector<ImageValues>& images_;
    int width_;
    std::size_t pixels_;
    std::vector<std::size_t> highest_;  // image
    std::vector<double> rest_;          // what the others show in the mean
    std::vector<double> limit_;
    std::vector<double> square_;  // about the variance of what an image shows
};

}  // namespace

SpreadOutliers spread_outliers(const std::vector<ImageValues>& images, int width) { return Outliers(images, width).spread(); }

}  // namespace pencil
