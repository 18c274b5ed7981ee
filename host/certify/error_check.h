// The error of an image as light paths see it, which know nothing of how it was made. For a pixel of value x and two independent unbiased
// estimates p1, p2 of its true value m, the mean of (x - p1)(x - p2) is (x - m)^2: noise, bias and all. Some hundred pixels with some hundred
// paths each tell the error of the whole image, with an interval. Emission that the film sees has no error but the spread of passes, and much
// of the noise of paths would be its: it is left out of both.
#pragma once

#include <vector>

#include "certify/known_pixels.h"
#include "certify/trace_checks.h"
#include "film/film.h"
#include "film/render_context.h"
#include "util/archive.h"

namespace pencil {

/// Estimated relMSE from both sources: `spread`, among the passes, is precise and blind to what all passes share; infinite if there is one. What
/// the check finds beyond it counts as far as it stands out of the check's noise.
double join_errors(double spread, const CertifiedError& certified);

class ErrorCheck {
public:
    explicit ErrorCheck(RenderContext& context);

    /// Emission of a film as the image shows it, rgb per pixel, with the film's weight in the image.
    void add_emission(const std::vector<float>& emission, double weight);

    /// Looks at some pixels with about `paths` paths in all: at those of the last call once more, and at new ones. The two estimates of a pixel
    /// come from the visibility samples of two films, so that the error of these is seen, too. DeviceError, MemoryError.
    void add(const Film& film, int paths, std::uint64_t seed);

    /// Of `beauty`, rgb per pixel, against all that was looked at so far. Nothing of an image that holds values that are not finite. Errors of a
    /// black one are relative to what paths find.
    CertifiedError certify(const std::vector<float>& beauty, const std::vector<float>& usual) const;

    /// All that was looked at; ArchiveError unless it is of a film of `pixels` pixels.
    void transfer(Archive& archive, std::size_t pixels);

private:
    struct Point {
        std::size_t pixel;
        glm::dvec3 first, second;  // independent estimates of what it shows of reflected light
    };

    static double scale_of(const std::vector<Point>& points, const std::vector<float>& beauty);
    std::vector<PixelLooks> looks_at(const std::vector<Point>& points, const std::vector<float>& beauty) const;
    double reflected(const std::vector<float>& beauty, std::size_t i) const;
    std::vector<glm::dvec3> estimate(const Film& film, const std::vector<std::size_t>& pixels, int paths, std::uint64_t seed) const;

    RenderContext& context_;
    CheckLights lights_;
    std::vector<Point> points_;
    std::vector<double> emission_;  // sum of weight * emission, rgb per pixel
    double weight_ = 0;
    std::vector<Point> half_done_;  // of the last call: both estimates from one film, which is better than nothing
};

}  // namespace pencil
