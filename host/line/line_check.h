// What light paths say of an image by lines. It has no passes whose spread could tell its error, and may be wrong by any factor where few
// pencils see the light.
#pragma once

#include <string>
#include <vector>

#include "film/bounce_series.h"
#include "film/frame.h"

namespace pencil {

class LineCheck {
public:
    /// False for views of fields, which take less time than a check, for parts of images, where a field is made, and where light samples carry all
    /// light: no pencils are made then. `maps_emit`: some emitter is carried by maps.
    static bool wanted(const RenderOptions& options, bool maps_emit);

    /// Remembers what the frame shows so far: emission.
    void begin(const Frame& frame) { emission_ = frame.layers().beauty(); }
    /// Checks the image, whose orders of reflection are those of the series. Adds a warning where the mean is surely wrong.
    void end(RenderContext& context, const Frame& frame, const BounceSeries& series);

    /// Nothing before end().
    const CertifiedError& found() const { return found_; }
    /// Why there was none; empty otherwise.
    const std::string& left_out() const { return left_out_; }

private:
    void look(RenderContext& context, const Frame& frame, double length);

    std::vector<float> emission_;  // rgb per pixel
    CertifiedError found_;
    std::string left_out_;
};

}  // namespace pencil
