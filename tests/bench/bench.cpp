#include "bench/bench.h"

#include <chrono>
#include <cmath>
#include <set>

namespace pencil::bench {
namespace {

Sizes current;
std::string selected;
bool mismatched = false;

double device_seconds(const std::vector<std::string>& descriptions) {
    double sum = 0;
    const std::map<std::string, LaunchTimes> times = device()->launch_times();
    for (const std::string& description : descriptions) {
        const auto found = times.find(description);
        if (found != times.end()) sum += found->second.device_seconds;
    }
    return sum;
}

double wall_seconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Warms both up and compares their results; once per benchmark, which google-benchmark enters several times.
bool checked(benchmark::State& state, const Line& line, const std::function<void()>& kernel, const std::function<void()>& native,
             const std::function<std::string()>& mismatch) {
    static std::set<std::string> done;
    if (!done.insert(line.descriptions.front() + line.size).second) return true;
    kernel();
    device()->finish();
    native();
    const std::string wrong = mismatch();
    if (wrong.empty()) return true;
    mismatched = true;
    state.SkipWithError(("kernel and native loop disagree: " + wrong).c_str());
    return false;
}

template <typename T, typename Equal>
std::string count_differences(const std::vector<T>& got, const std::vector<T>& expected, double allowed, const Equal& equal) {
    if (got.size() != expected.size()) return "sizes " + std::to_string(got.size()) + " and " + std::to_string(expected.size());
    std::size_t different = 0, first = 0;
    for (std::size_t i = 0; i < got.size(); ++i)
        if (!equal(got[i], expected[i]) && different++ == 0) first = i;
    if (static_cast<double>(different) <= allowed * static_cast<double>(got.size())) return "";
    return std::to_string(different) + " of " + std::to_string(got.size()) + " values, first number " + std::to_string(first) + ": " +
           std::to_string(got[first]) + " and " + std::to_string(expected[first]);
}

}  // namespace

const Sizes& sizes() { return current; }
void use_tiny_sizes() { current = {16, 32, 20, 8, 6, 48, 4, 3, 60}; }

const std::shared_ptr<Device>& device() {
    static const std::shared_ptr<Device> opened = Device::open(selected);
    return opened;
}
void select_device(const std::string& selector) { selected = selector; }
bool any_mismatch() { return mismatched; }

void compare(benchmark::State& state, const Line& line, const std::function<void()>& kernel, const std::function<void()>& native,
             const std::function<std::string()>& mismatch) {
    if (!checked(state, line, kernel, native, mismatch)) return;
    double kernel_time = 0, native_time = 0;
    for ([[maybe_unused]] auto run : state) {
        const double before = device_seconds(line.descriptions);
        kernel();
        const double seconds = device_seconds(line.descriptions) - before;
        state.SetIterationTime(seconds);
        kernel_time += seconds;
        native_time += wall_seconds(native);
    }
    const auto runs = static_cast<double>(state.iterations());
    state.counters["items_per_second"] = runs * line.operations / kernel_time;
    state.counters["bytes_per_second"] = runs * line.bytes / kernel_time;
    state.counters["native_items_per_second"] = runs * line.operations / native_time;
    state.counters["ratio"] = native_time / kernel_time;
    state.SetLabel(line.size);
}

void time_alone(benchmark::State& state, const Line& line, const std::function<void()>& kernel,
                const std::function<std::string()>& mismatch) {
    if (!checked(
            state, line, kernel, [] {}, mismatch))
        return;
    double sum = 0;
    for ([[maybe_unused]] auto run : state) {
        const double before = device_seconds(line.descriptions);
        kernel();
        const double seconds = device_seconds(line.descriptions) - before;
        state.SetIterationTime(seconds);
        sum += seconds;
    }
    state.counters["items_per_second"] = static_cast<double>(state.iterations()) * line.operations / sum;
    state.SetLabel(line.size);
}

std::string differences(const std::vector<float>& got, const std::vector<float>& expected, double relative, double allowed) {
    double magnitude = 0;
    for (const float value : expected) magnitude += std::abs(static_cast<double>(value));
    const double tolerance = relative * magnitude / static_cast<double>(std::max<std::size_t>(expected.size(), 1));
    return count_differences(got, expected, allowed, [&](float a, float b) { return std::abs(static_cast<double>(a) - b) <= tolerance; });
}

std::string differences(const std::vector<int>& got, const std::vector<int>& expected, double allowed) {
    return count_differences(got, expected, allowed, [](int a, int b) { return a == b; });
}

}  // namespace pencil::bench
