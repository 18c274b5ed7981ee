// Which way geometry maps are made fastest on a device: the factors of the cost model (visibility/visibility_path.h).
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "tune/tune.h"
#include "visibility/visibility_path.h"

namespace pencil {

using MapCosts = std::array<double, visibility_paths.size()>;

/// Times of all paths for one batch over so many triangles [s], the least of some rounds; infinite for a path that makes other maps than
/// the rasteriser.
struct MapTimes {
    int triangles = 0;
    MapBatch batch;
    MapCosts seconds{};
};

/// Measures small and large maps over few and many triangles. Calls `go_on` between launches, which may throw.
std::vector<MapTimes> measure_maps(const std::shared_ptr<Device>& device, int rounds, const std::function<void()>& go_on);

/// Factors that fit the times, as powers of the root of 2; `costs_of_wrong_path` for one that makes other maps.
MapCosts fitted_costs(const std::vector<MapTimes>& times, int compute_units);
constexpr double costs_of_wrong_path = 1e3;

/// Time of the choices that the cost model makes with some factors, everything being prepared [s].
double seconds_of_choices(const std::vector<MapTimes>& times, int compute_units, const MapCosts& costs);

/// Fitted factors, or those `stored`, if the choices that they make are faster than those without by the margins of tune.h; else 1. Adds the row.
MapCosts choose_costs(const std::vector<MapTimes>& times, int compute_units, const MapCosts& stored, std::vector<TuneRow>& rows);

}  // namespace pencil
