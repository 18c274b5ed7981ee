#include "converge/verdict.h"

#include <algorithm>
#include <cmath>

namespace pencil {

Verdict judge(const std::vector<NamedCurve>& curves, double seconds) {
    Verdict verdict;
    verdict.seconds = seconds;
    std::vector<int> measured;
    for (const NamedCurve& named : curves) {
        verdict.errors.push_back(error_at(named.curve, seconds));
        if (verdict.errors.back().kind == Reading::Kind::measured) measured.push_back(static_cast<int>(verdict.errors.size()) - 1);
    }
    const auto error = [&](int index) { return verdict.errors[static_cast<std::size_t>(index)].value; };
    std::stable_sort(measured.begin(), measured.end(), [&](int a, int b) { return error(a) < error(b); });
    verdict.ahead = measured.empty() ? -1 : measured[0];
    if (measured.size() > 1) {
        verdict.second = measured[1];
        verdict.lead = error(measured[1]) / error(measured[0]);
    }
    return verdict;
}

TimesToError times_to(const std::vector<NamedCurve>& curves, double error) {
    TimesToError row;
    row.error = error;
    for (const NamedCurve& named : curves) row.times.push_back(time_to(named.curve, error));
    for (const Reading& time : row.times) {
        const bool both = time.kind == Reading::Kind::measured && row.times.front().kind == Reading::Kind::measured;
        row.speedups.push_back(both ? row.times.front().value / time.value : 0);
    }
    return row;
}

std::vector<double> round_errors(const std::vector<NamedCurve>& curves) {
    double low = INFINITY, high = 0;
    for (const NamedCurve& named : curves) {
        for (const CurvePoint& point : named.curve) {
            low = std::min(low, point.error);
            high = std::max(high, point.error);
        }
    }
    std::vector<double> errors;
    if (high > 0) {
        for (int power = static_cast<int>(std::floor(std::log10(high))); power >= static_cast<int>(std::floor(std::log10(low))); --power) {
            for (const double mantissa : {5.0, 2.0, 1.0}) {
                const double error = mantissa * std::pow(10.0, power);
                if (error >= low && error <= high) errors.push_back(error);
            }
        }
    }
    return errors;
}

}  // namespace pencil
