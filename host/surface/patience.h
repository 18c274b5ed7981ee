// Whether the passes so far are enough, where no time is given: by the estimated error, or because it falls no further.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "certify/error_check.h"
#include "util/archive.h"

namespace pencil {

/// What passes say of themselves so far.
struct PassesSoFar {
    int passes;
    double work;        // of all, in terms of that of a pass whose world set has no more rays than it needs
    double error;       // estimated relMSE
    double sure_error;  // it is at least this, as far as the noise of the check by light paths tells
    double mean_error;  // of the mean of all pixels, relative to it, as Student's distribution widens it
    CertifiedError certified;
};

/// The mean of all pixels is to be this much better known than each of them, if that does not take many passes: it is what is seen as too
/// bright or too dark.
constexpr double mean_share = 0.125;
/// And twice as well where that leaves more than this: nobody takes a percent in the mean for noise.
constexpr double usual_mean_error = 0.004;

/// Two passes agree by chance too often.
constexpr int least_passes = 3;

class Patience {
public:
    explicit Patience(double target_error) : target_(target_error) {}

    /// Asked after each pass. A reason where the target has not been met.
    struct Answer {
        bool enough;
        std::optional<std::string> reason;
    };
    Answer ask(const PassesSoFar& so_far);

    void transfer(Archive& archive) { archive(known_to_, error_passes_, last_error_); }

private:
    bool knows_the_mean(const PassesSoFar& so_far);

    double target_;
    double known_to_ = std::numeric_limits<double>::infinity();  // the mean, after the last pass; infinite where light paths contradict
    int error_passes_ = 0;                                       // a power of two,
    double last_error_ = 0;                                      // after which the error was this
};

}  // namespace pencil
