// One benchmark is one line of the table: a kernel and the native loop of the same work, run by turns so that both meet the same noise,
// their results compared before the first measurement.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

#include "cl/device.h"

namespace pencil::bench {

/// Sizes of all benchmarks: those of an ordinary render, or tiny ones (--tiny) that only check results.
struct Sizes {
    int map = 64, light_map = 256;  // texels along a side of a tile
    int pencils = 128, light_samples = 64;
    int tiles = 64;  // of the next set, whose texels are the surfels of pencil transport
    int film = 512, film_samples = 16;
    int most_maps = 328;  // of visibility_paths
    int world = 800;      // surface pencils of the world set, about
};
const Sizes& sizes();
void use_tiny_sizes();

/// The device chosen by --device, $PENCIL_DEVICE, or by itself; opened at the first use.
const std::shared_ptr<Device>& device();
void select_device(const std::string& selector);

/// What a line is about.
struct Line {
    std::string size;                       // in words: "262144 surfels x 128 pencils"
    double operations = 0;                  // per run
    double bytes = 0;                       // read and written by the operations, per run
    std::vector<std::string> descriptions;  // of the launches whose device time counts
};

/// Runs `kernel` and `native` by turns. `mismatch` is called once, after the first of each: it returns what is wrong, or nothing.
/// Time is the device's (launch profiling) for the kernel, wall time for the native loop. Counters: items_per_second and
/// bytes_per_second of the kernel, native_items_per_second, ratio (native time / kernel time: 1 is as fast as native).
void compare(benchmark::State& state, const Line& line, const std::function<void()>& kernel, const std::function<void()>& native,
             const std::function<std::string()>& mismatch);

/// Runs `kernel` alone, where it is compared with other kernels; its time is the device's.
void time_alone(benchmark::State& state, const Line& line, const std::function<void()>& kernel,
                const std::function<std::string()>& mismatch);

/// True if a benchmark found a wrong result.
bool any_mismatch();

/// Empty if all but `allowed` (a fraction) of `got` are within `relative` of `expected`, relative to the mean magnitude; else how many are
/// not, and the first. Rounding may decide ties of coverage and visibility either way, so some values differ altogether.
std::string differences(const std::vector<float>& got, const std::vector<float>& expected, double relative, double allowed);
/// The same for values that are equal or not.
std::string differences(const std::vector<int>& got, const std::vector<int>& expected, double allowed);

}  // namespace pencil::bench
