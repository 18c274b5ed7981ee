#include "tune/trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "image/relative_error.h"
#include "util/error.h"

namespace pencil {
namespace {

/// relMSE of an image; infinite if it is no image of the same size.
double difference(const std::vector<float>& image, const std::vector<float>& reference) {
    if (image.size() != reference.size() || reference.empty()) return std::numeric_limits<double>::infinity();
    const auto count = static_cast<double>(reference.size());
    const double mean = std::accumulate(reference.begin(), reference.end(), 0.0) / count;
    double sum = 0;
    for (std::size_t i = 0; i < image.size(); ++i) sum += relative_square(image[i], reference[i], mean);
    return std::isfinite(sum) ? sum / count : std::numeric_limits<double>::infinity();
}

/// Compares, and has code made.
void warm_up(const Workload& work, Trial& trial, const std::vector<float>& reference) {
    try {
        const double off = difference(work(trial.profile).image, reference);
        if (!(off <= same_results)) trial.refused = fmt::format("wrong results: relMSE {:.1e}", off);
    } catch (const DeviceError&) {
        trial.refused = "the device fails";
    } catch (const MemoryError&) {
        trial.refused = "out of memory";
    }
}

double least_sum(const Trial& trial) {
    double least = std::numeric_limits<double>::infinity();
    for (const KernelTimes& seconds : trial.rounds) least = std::min(least, sum_of(seconds, {}));
    return least;
}

/// So much slower in its first rounds that more of them are a waste.
bool is_hopeless(const Trial& trial, const Trial& to) {
    constexpr std::size_t enough_rounds = 3;
    constexpr double much = 1.3;
    return trial.rounds.size() >= enough_rounds && least_sum(trial) > much * least_sum(to);
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Of times of one trial and another: that of the least, and the median of the rounds'.
struct Ratios {
    double least = 1, median = 1;
};

Ratios ratios_of(const Trial& trial, const Trial& to, const std::set<std::string>& kernels) {
    const double infinite = std::numeric_limits<double>::infinity();
    const std::size_t rounds = std::min(trial.rounds.size(), to.rounds.size());
    if (!trial.refused.empty() || rounds == 0) return {infinite, infinite};
    double least = infinite, least_to = infinite;
    std::vector<double> ratios;
    for (std::size_t i = 0; i < rounds; ++i) {
        const double own = sum_of(trial.rounds[i], kernels), other = sum_of(to.rounds[i], kernels);
        if (!(other > 0)) return {};  // a driver that measures no times, or kernels that were not launched
        least = std::min(least, own);
        least_to = std::min(least_to, other);
        ratios.push_back(own / other);
    }
    return {least / least_to, median(ratios)};
}

}  // namespace

std::vector<Trial> try_profiles(const Workload& work, const std::vector<DeviceProfile>& profiles, int rounds) {
    std::vector<Trial> trials;
    trials.reserve(profiles.size());
    for (const DeviceProfile& profile : profiles) trials.push_back({profile, "", {}});
    const std::vector<float> reference = work(profiles.front()).image;
    for (std::size_t i = 1; i < trials.size(); ++i) warm_up(work, trials[i], reference);
    for (int round = 0; round < rounds; ++round)
        for (Trial& trial : trials)
            if (trial.refused.empty() && !is_hopeless(trial, trials.front())) trial.rounds.push_back(work(trial.profile).seconds);
    return trials;
}

double sum_of(const KernelTimes& seconds, const std::set<std::string>& kernels) {
    double sum = 0;
    for (const auto& [kernel, time] : seconds)
        if (kernels.empty() || kernels.count(kernel) > 0) sum += time;
    return sum;
}

double time_ratio(const Trial& trial, const Trial& to, const std::set<std::string>& kernels) {
    const Ratios ratios = ratios_of(trial, to, kernels);
    return std::max(ratios.least, ratios.median);
}

double noise_between(const Trial& trial, const Trial& again, const std::set<std::string>& kernels) {
    const Ratios ratios = ratios_of(trial, again, kernels);
    return std::max(std::abs(std::log(ratios.least)), std::abs(std::log(ratios.median)));
}

}  // namespace pencil
