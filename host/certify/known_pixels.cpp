#include "certify/known_pixels.h"

#include <algorithm>
#include <cmath>

#include "image/relative_error.h"

namespace pencil {

CertifiedError certify_pixels(const std::vector<PixelLooks>& looks, const std::vector<float>& shown, double mean) {
    CertifiedError error;
    double squares = 0, square_variance = 0, steps = 0, step_variance = 0, values = 0;
    for (std::size_t pixel = 0; pixel < looks.size(); ++pixel) {
        const PixelLooks& of = looks[pixel];
        if (of.count < 2) continue;
        const double n = of.count;
        error.points += of.count / 2;  // looks come in pairs
        double variance_of_step = 0;
        for (int c = 0; c < 3; ++c, ++values) {
            const double scale = relative_to(static_cast<double>(shown[3 * pixel + static_cast<std::size_t>(c)]), mean);
            const double square = (of.steps[c] * of.steps[c] - of.squares[c]) / (n * (n - 1));
            const double variance = std::max(of.squares[c] - of.steps[c] * of.steps[c] / n, 0.0) / (n - 1);
            squares += square / scale;
            // Channels mostly err alike: their errors add up, not their squares.
            square_variance += 3 * (2 * variance * variance / (n * (n - 1)) + 4 * std::max(square, 0.0) * variance / n) / (scale * scale);
            steps += of.steps[c] / n / mean;
            variance_of_step += 3 * variance / n / (mean * mean);
        }
        step_variance += variance_of_step;
    }
    if (values == 0) return error;
    error.relmse = squares / values;
    error.standard_error = std::sqrt(square_variance) / values;
    error.mean_bias = steps / values;
    error.mean_error = std::sqrt(step_variance) / values;
    return error;
}

}  // namespace pencil
