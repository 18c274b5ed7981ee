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
    const auto all = [&](auto holds) { return std::all_of(result.measured.begin(), result.measured.end(), holds); };
    if (!result.error.empty() || !all([&](const Measurement& m) { return as_expected(result, m); })) return Verdict::fails;
    return all([](const Measurement& m) { return m.holds(); }) ? Verdict::holds : Verdict::known;
}

}  // namespace

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

bool as_expected(const StressResult& result, const Measurement& m) {
    const std::vector<std::string>& excused = result.row.excused;
    return m.holds() || std::find(excused.begin(), excused.end(), m.what) != excused.end();
}

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
