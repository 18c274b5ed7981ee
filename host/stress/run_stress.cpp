#include "stress/run_stress.h"

#include <algorithm>
#include <ctime>
#include <exception>

#include "stress/stress_render.h"
#include "util/stopwatch.h"

namespace pencil {

namespace {

/// Of all threads.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Verdict verdict_of(const StressResult& result) {
    const bool all = std::all_of(result.measured.begin(), result.measured.end(), [](const Measurement& m) { return m.holds(); });
    return result.error.empty() && all ? Verdict::holds : Verdict::fails;
}

}  // namespace

std::string to_string(Verdict verdict) { return verdict == Verdict::holds ? "holds" : "FAILS"; }

StressResult run_case(const StressCase& row, const std::shared_ptr<Device>& device, const Progress& progress) {
    StressResult result;
    result.row = row;
    const Stopwatch watch;
    const double built = device->build_seconds(), processor = processor_seconds();
    try {
        result.measured = row.run({device, progress});
    } catch (const StressStopped&) {
        result.stopped = true;
    } catch (const std::exception& error) {
        result.error = error.what();
    }
    const double wall = watch.seconds() - (device->build_seconds() - built);
    result.seconds = device->info().is_cpu ? std::min(wall, processor_seconds() - processor) : wall;
    result.measured.push_back(below("seconds", result.seconds, stress_seconds));
    result.verdict = verdict_of(result);
    return result;
}

}  // namespace pencil
