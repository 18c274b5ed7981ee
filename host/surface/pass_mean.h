// The image as the mean of the passes, and how wrong it is: by the spread of the passes and by light paths.
#pragma once

#include <vector>

#include "certify/error_check.h"
#include "film/layer_mean.h"
#include "film/render_context.h"
#include "film/weighted_mean.h"
#include "surface/surface_pass.h"
#include "util/archive.h"

namespace pencil {

/// How wrong an image is.
struct PassErrors {
    double error;       // estimated relMSE; infinite if not known
    double sure_error;  // it is at least this, as far as the noise of the check by light paths tells
    double mean_error;  // of the mean of all pixels, relative to it, as Student's distribution widens it
    CertifiedError certified;
};

class PassMean {
public:
    explicit PassMean(RenderContext& context);

    /// Adds the layers of a pass, and the emission among its beauty, rgb per pixel.
    void add(std::vector<Layer> layers, const std::vector<float>& emission, const SurfacePass& pass);
    ErrorCheck& check() { return check_; }

    int count() const { return mean_.count(); }
    /// Needs a pass for more than infinite errors.
    PassErrors errors() const;

    /// Estimated relative variances of a pixel, and of the mean of all, in one pass; 0 before there are two.
    double noise_of_pixels() const { return mean_.count() > 1 ? mean_.mean_square_noise() * mean_.count() : 0; }
    double noise_of_mean() const;
    /// Per pixel, not 0 where a pass is to look closer: there most of the noise comes from.
    std::vector<unsigned char> noisy_pixels() const { return mean_.noisy_pixels(16); }

    /// The layers as they are shown, with the error of the beauty; needs a pass. take() leaves nothing behind.
    std::vector<Layer> snapshot() const;
    std::vector<Layer> take();

    /// All of it; ArchiveError.
    void transfer(Archive& archive);

private:
    double mean_error_of_pixels() const;
    const LayerMean& shown(LayerMean& copy) const;
    bool spreads_outliers() const;

    RenderContext& context_;
    LayerMean mean_;
    WeightedMean of_pixels_;  // means of all pixels, by world sets
    ErrorCheck check_;
};

}  // namespace pencil
