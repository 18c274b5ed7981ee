// What light paths say of an image by lines. It has no passes whose spread could tell its error, and may be wrong by any factor where few
// pencils see the light.
#pragma once

#include <string>
#include <vector>

#include "film/frame.h"

namespace pencil {

class LineCheck {
public:
    /// False for views of fields, which take less time than a check, and for parts of images.
    static bool wanted(const RenderOptions& options);

    /// Remembers what the frame shows so far: emission.
    void begin(const Frame& frame) { emission_ = frame.layers().beauty(); }
    /// Checks the image; `ratio`: of successive orders of reflection. Adds a warning where the mean is surely wrong.
    void end(RenderContext& context, const Frame& frame, double ratio);

    /// Nothing before end().
    const CertifiedError& found() const { return found_; }
    /// Why there was none; empty otherwise.
    const std::string& left_out() const { return left_out_; }

private:
    std::vector<float> emission_;  // rgb per pixel
    CertifiedError found_;
    std::string left_out_;
};

}  // namespace pencil
