// Which way geometry maps are made. Three ways give the same maps, ties of rounding apart: each triangle drawn into each map, clusters of
// triangles drawn where they may be seen, packets of rays traced through a hierarchy. A cost model chooses.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cl/device.h"
#include "device/device_scene.h"
#include "device/map_shape.h"
#include "shared/map_kind.h"

namespace pencil {

enum class VisibilityPath { rasterize, clusters, trace };
constexpr std::array<VisibilityPath, 3> visibility_paths{VisibilityPath::rasterize, VisibilityPath::clusters, VisibilityPath::trace};

/// Maps of `size` x `size` texels, or of other kinds with as many.
struct MapBatch {
    int maps = 0, size = 0;
};

/// How fast a device makes maps: its compute units, and the time of each path relative to the prediction for as many units.
struct MapSpeed {
    MapSpeed(int units) : compute_units(units) {}  // NOLINT(google-explicit-constructor): a device of so many units as it comes
    explicit MapSpeed(const Device& device)
        : compute_units(static_cast<int>(device.info().compute_units)), costs(device.profile().map_costs) {}

    int compute_units;
    std::array<double, visibility_paths.size()> costs{1, 1, 1};
};

/// Predicted host time to prepare a path [s]: nothing, 90 ns per triangle for clusters, 0.2 ms and 700 ns per triangle for a hierarchy.
double preparation_seconds(VisibilityPath path, int triangles);

/// Predicted time of a batch on a device [s], preparation apart:
///     costs maps (a + b triangles + c size^2 + d triangles size^e) / compute_units
///                  a [us]   b [ns]   c [ns]   d [ns]    e
///     rasterize     11.2     57       11.0     0.041    1.25
///     clusters      13.3      1.5     11.0     0.275    1
///     trace          1.0      0       28.1     0.0126   1.5
/// Least squares of relative errors over the 36 times of docs/performance.md ("Ways to make geometry maps"), all of which it meets within a
/// factor of 1.25. They are those of two cores with AVX-512; other CPUs are slower or faster by about the same factor for all three;
/// `pencil tune` measures the factors of a device.
double maps_seconds(VisibilityPath path, int triangles, const MapBatch& batch, const MapSpeed& speed);

/// The fastest path of those that are prepared and make maps of `kind` (shared/map_kind.h): single triangles are drawn into octahedral maps
/// alone, clusters into all that have facets. Rays need a map size that is a multiple of 4.
VisibilityPath choose_path(int triangles, const MapBatch& batch, const MapSpeed& speed, const Prepared& prepared,
                           int kind = PENCIL_MAP_OCTAHEDRAL);

/// What to prepare so that preparation and all batches together take the least time; as little as possible where it makes no difference.
Prepared plan_preparation(int triangles, const std::vector<MapBatch>& batches, const MapSpeed& speed, int kind = PENCIL_MAP_OCTAHEDRAL);

/// One sentence for --explain: the choice for each batch, and what each path would take.
std::string explain_paths(int triangles, const std::vector<MapBatch>& batches, const MapSpeed& speed, const Prepared& prepared,
                          int kind = PENCIL_MAP_OCTAHEDRAL);

}  // namespace pencil
