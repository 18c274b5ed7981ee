#include "reference/sample_plan.h"

#include <algorithm>
#include <cmath>

namespace pencil {
namespace {

/// Sets for the variance of each pixel, and for the error of the whole image: two cost no stratification that matters.
constexpr int sets_for_variance = 16, sets_for_error = 2;
constexpr int pass_samples = 16;  // at most: progress is told and the clock read between passes

/// A power of two, so that there are `sets` or up to twice as many.
int set_size(int samples, int sets) {
    int size = 1;
    while (size <= samples / (2 * sets)) size *= 2;
    return size;
}

}  // namespace

SamplePlan::SamplePlan(const ReferenceOptions& options)
    : options_(options),
      sets_(options.variance ? sets_for_variance : sets_for_error),
      set_size_(options.seconds > 0 ? 1 : set_size(options.spp, sets_)) {}

SamplePlan::Pass SamplePlan::next(double elapsed) {
    done_ += current_.samples;
    in_set_ += current_.samples;
    if (current_.ends_set) {
        ++set_;
        in_set_ = 0;
        // Only the first pass tells how much a time budget buys.
        if (options_.seconds > 0 && set_ == 1) set_size_ = set_size(static_cast<int>(std::min(options_.seconds / elapsed, 1e9)), sets_);
    }
    current_ = {};
    current_.samples = std::min(wanted(elapsed), set_size_ - in_set_);
    current_.set = set_;
    current_.first = in_set_;
    current_.ends_set = in_set_ + current_.samples == set_size_;
    return current_;
}

int SamplePlan::wanted(double elapsed) const {
    if (options_.seconds <= 0) return std::min(pass_samples, options_.spp - done_);
    if (done_ == 0) return 1;
    const double seconds_per_sample = std::max(elapsed, 1e-9) / done_;
    const double affordable = (options_.seconds - elapsed) / seconds_per_sample;  // rounded: half a sample too long, or too short
    return static_cast<int>(std::clamp(std::floor(affordable + 0.5), 0.0, static_cast<double>(std::min(pass_samples, done_))));
}

double SamplePlan::fraction(double part, double elapsed) const {
    if (options_.seconds > 0) return elapsed / options_.seconds;
    return (done_ + part * current_.samples) / options_.spp;
}

}  // namespace pencil
