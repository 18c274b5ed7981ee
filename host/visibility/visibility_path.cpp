#include "visibility/visibility_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

namespace pencil {

namespace {

/// The header's formula, times in nanoseconds.
struct PathCost {
    double map, triangle, texel, shared, exponent;
};

PathCost cost_of(VisibilityPath path) {
    switch (path) {
        case VisibilityPath::rasterize:
            return {11.2e3, 57.0, 11.0, 0.041, 1.25};
        case VisibilityPath::clusters:
            return {13.3e3, 1.5, 11.0, 0.275, 1.0};
        case VisibilityPath::trace:
            return {1.0e3, 0.0, 28.1, 0.0126, 1.5};
    }
    return {};
}

/// Whether a path makes maps of a kind.
bool knows(VisibilityPath path, int kind) {
    switch (path) {
        case VisibilityPath::rasterize:
            return kind == PENCIL_MAP_OCTAHEDRAL;
        case VisibilityPath::clusters:
            return PENCIL_MAP_FACETS(kind) > 0;
        case VisibilityPath::trace:
            return true;
    }
    return false;
}

bool available(VisibilityPath path, const MapBatch& batch, const Prepared& prepared, int kind) {
    if (!knows(path, kind)) return false;
    switch (path) {
        case VisibilityPath::rasterize:
            return true;
        case VisibilityPath::clusters:
            return prepared.clusters;
        case VisibilityPath::trace:
            return prepared.bvh && MapShape(kind, batch.size).n % 4 == 0;
    }
    return false;
}

const char* words(VisibilityPath path) {
    switch (path) {
        case VisibilityPath::rasterize:
            return "rasterised";
        case VisibilityPath::clusters:
            return "rasterised by clusters";
        case VisibilityPath::trace:
            return "traced";
    }
    return "";
}

/// Two digits [s].
std::string seconds_text(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g s", seconds);
    return text;
}

/// Whether some path makes a batch.
bool possible(const MapBatch& batch, const Prepared& prepared, int kind) {
    return std::any_of(
        visibility_paths.begin(), visibility_paths.end(), [&](VisibilityPath path) { return available(path, batch, prepared, kind); });
}

/// Infinite if some batch cannot be made.
double total_seconds(int triangles, const std::vector<MapBatch>& batches, const MapSpeed& speed, const Prepared& prepared, int kind) {
    double sum = prepared.clusters ? preparation_seconds(VisibilityPath::clusters, triangles) : 0.0;
    if (prepared.bvh) sum += preparation_seconds(VisibilityPath::trace, triangles);
    for (const MapBatch& batch : batches) {
        if (!possible(batch, prepared, kind)) return std::numeric_limits<double>::infinity();
        sum += maps_seconds(choose_path(triangles, batch, speed, prepared, kind), triangles, batch, speed);
    }
    return sum;
}

}  // namespace

double preparation_seconds(VisibilityPath path, int triangles) {
    switch (path) {
        case VisibilityPath::rasterize:
            return 0.0;
        case VisibilityPath::clusters:
            return 90e-9 * triangles;
        case VisibilityPath::trace:
            return 0.2e-3 + 700e-9 * triangles;
    }
    return 0.0;
}

double maps_seconds(VisibilityPath path, int triangles, const MapBatch& batch, const MapSpeed& speed) {
    const PathCost cost = cost_of(path);
    const double size = batch.size;
    const double map =
        cost.map + cost.triangle * triangles + cost.texel * size * size + cost.shared * triangles * std::pow(size, cost.exponent);
    return 1e-9 * speed.costs[static_cast<std::size_t>(path)] * batch.maps * map / speed.compute_units;
}

VisibilityPath choose_path(int triangles, const MapBatch& batch, const MapSpeed& speed, const Prepared& prepared, int kind) {
    VisibilityPath best = VisibilityPath::rasterize;
    double least = std::numeric_limits<double>::infinity();
    for (const VisibilityPath path : visibility_paths) {
        const double seconds = maps_seconds(path, triangles, batch, speed);
        if (!available(path, batch, prepared, kind) || seconds >= least) continue;
        best = path;
        least = seconds;
    }
    if (!std::isfinite(least)) throw std::logic_error("no way to make these geometry maps has been prepared");
    return best;
}

Prepared plan_preparation(int triangles, const std::vector<MapBatch>& batches, const MapSpeed& speed, int kind) {
    Prepared best;
    double least = std::numeric_limits<double>::infinity();
    for (const Prepared& prepared : {Prepared{false, false}, Prepared{true, false}, Prepared{false, true}, Prepared{true, true}}) {
        const double seconds = total_seconds(triangles, batches, speed, prepared, kind);
        if (seconds >= least) continue;
        best = prepared;
        least = seconds;
    }
    return best;
}

std::string explain_paths(int triangles, const std::vector<MapBatch>& batches, const MapSpeed& speed, const Prepared& prepared, int kind) {
    std::string text = fmt::format("geometry maps over {} triangles: ", triangles);
    for (const MapBatch& batch : batches) {
        text += fmt::format("about {} {} {} (predicted:", batch.maps, describe(MapShape(kind, batch.size)),
                            words(choose_path(triangles, batch, speed, prepared, kind)));
        const char* separator = " ";
        for (const VisibilityPath path : visibility_paths) {
            if (!knows(path, kind)) continue;
            text += separator + (words(path) + (" " + seconds_text(maps_seconds(path, triangles, batch, speed))));
            separator = ", ";
        }
        text += "); ";
    }
    if (!prepared.clusters && !prepared.bvh) return text + "nothing to prepare";
    text += "preparation:";
    if (prepared.clusters) text += " clusters " + seconds_text(preparation_seconds(VisibilityPath::clusters, triangles));
    if (prepared.bvh)
        text +=
            std::string(prepared.clusters ? "," : "") + " hierarchy " + seconds_text(preparation_seconds(VisibilityPath::trace, triangles));
    return text;
}

}  // namespace pencil
