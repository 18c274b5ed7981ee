#include "stress/run_stress.h"

#include <algorithm>
#include <exception>

#include "util/stopwatch.h"

namespace pencil {

std::string to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::holds:
            return "holds";
        case Verdict::known:
            return "fails, known";
        case Verdict::fails:
            break;
    }
    return "FAILS";
}

StressResult run_case(const StressCase& row, const std::shared_ptr<Device>& device) {
    StressResult result;
    result.row = row;
    const Stopwatch watch;
    const double built = device->build_seconds();
    try {
        result.measured = row.run(device);
    } catch (const std::exception& error) {
        result.error = error.what();
    }
    result.seconds = watch.seconds() - (device->build_seconds() - built);
    result.measured.push_back(below("seconds", result.seconds, stress_seconds));
    const bool holds =
        result.error.empty() && std::all_of(result.measured.begin(), result.measured.end(), [](const Measurement& m) { return m.holds(); });
    result.verdict = holds ? Verdict::holds : row.known.empty() ? Verdict::fails : Verdict::known;
    return result;
}

}  // namespace pencil
