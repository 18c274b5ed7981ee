// Decides how many samples each pass over the film takes, and into which sets they fall.
#pragma once

#include "reference/path_tracer.h"

namespace pencil {

/// Sets hold a power of two of samples each. There are about 16 if the variance of each pixel is wanted, and two to four otherwise.
class SamplePlan {
public:
    explicit SamplePlan(const ReferenceOptions& options);

    struct Pass {
        int samples = 0;  // per pixel; 0: the work is done
        int set = 0;
        int first = 0;  // number of the first sample in its set
        bool ends_set = false;
    };
    /// `elapsed`: seconds since the first pass began. By `spp` the passes do not depend on it.
    Pass next(double elapsed);

    /// Of the work, when `part` of the current pass is done.
    double fraction(double part, double elapsed) const;

private:
    int wanted(double elapsed) const;

    ReferenceOptions options_;
    int done_ = 0, set_ = 0, in_set_ = 0, sets_, set_size_;
    Pass current_;
};

}  // namespace pencil
