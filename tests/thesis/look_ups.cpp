#include "thesis/look_ups.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec4.hpp>

namespace pencil::thesis {

namespace {

using glm::dvec4;
using ref::dvec3;

constexpr std::size_t checked_surfels = 64;  // against double precision
constexpr double slack = 1.05;               // LOOK_UP_SLACK of look_up_maps.cl

/// Tile size whose texels come nearest to `texels`.
int tile_size(int texels, int tiles) { return static_cast<int>(std::lround(std::sqrt(static_cast<double>(texels) / tiles))); }

Launch look_up_kernel(Kernels& kernels, const ref::NamedMap& map, bool fetch) {
    Defines defines = to_defines(kernels.features(), kernels.block());
    defines["PENCIL_MAP"] = map.prefix;
    defines["LOOK_UP_FETCH"] = fetch ? "1" : "0";
    if (!map.exponent.empty()) {
        defines["PENCIL_SUPERQUADRIC_EXPONENT"] = map.exponent;
        defines["PENCIL_SUPERQUADRIC_CONE"] = map.cone ? "1" : "0";
    }
    return kernels.cache().kernel("look_up_maps", PENCIL_SOURCE_DIR "/tests/thesis/look_up_maps.cl", defines);
}

/// One map of all pencils in device memory.
class FilledMap {
public:
    FilledMap(LitPencils& pencils, const ref::NamedMap& map, int texels)
        : pencils_(pencils),
          map_(map),
          n_(tile_size(texels, map.map.tiles)),
          texels_(pencils.fill(map.map, n_)),
          maps_(pencils.kernels().device(), texels_, "maps"),
          sums_(surfel_rgb(pencils.kernels().device(), pencils.surfels().capacity, "sums")) {}

    int n() const { return n_; }
    std::vector<float> sums() const { return sums_.read(); }

    /// Device time of one launch.
    double look_up(bool fetch) {
        const auto& device = pencils_.kernels().device();
        const std::string what = map_.map.name + (fetch ? " look-ups" : " footprints");
        const double before = device->launch_times()[what].device_seconds;
        const Surfels& surfels = pencils_.surfels();
        look_up_kernel(pencils_.kernels(), map_, fetch)
            .args(surfels.data, surfels.capacity, surfels.count, pencils_.cops(), static_cast<int>(pencils_.host_cops().size()), maps_,
                  map_.map.tiles, n_, sums_)
            .run(pencils_.kernels().blocks(surfels.count), what);
        return device->launch_times()[what].device_seconds - before;
    }

    /// What the kernel should have summed at a position.
    dvec3 expected_sum(const dvec3& position) const {
        dvec3 sum(0.0);
        for (std::size_t i = 0; i < pencils_.host_cops().size(); ++i) {
            const dvec3 v = position - dvec3(pencils_.host_cops()[i]);
            const ref::MapPoint p = map_.map.to_point(v);
            const ref::Footprint f = ref::bilinear_footprint(p.uv, n_);
            const int tile = static_cast<int>(i) * map_.map.tiles + p.tile;
            const auto at = [&](int dx, int dy) { return dvec4(texels_[texel_index(tile, f.x + dx, f.y + dy, n_)]); };
            const dvec4 texel = glm::mix(glm::mix(at(0, 0), at(1, 0), f.fx), glm::mix(at(0, 1), at(1, 1), f.fx), f.fy);
            if (glm::length(v) <= slack * texel.w) sum += dvec3(texel);
        }
        return sum;
    }

private:
    LitPencils& pencils_;
    const ref::NamedMap& map_;
    int n_;
    std::vector<float4> texels_;
    Buffer<float4> maps_;
    Buffer<float> sums_;
};

/// Differences of a map's sums [3][capacity] from those of the first map and from double precision.
void check(const LitPencils& pencils, const FilledMap& map, const std::vector<float>& first, LookUpTimes& times) {
    const std::vector<float> got = map.sums();
    const auto capacity = static_cast<std::size_t>(pencils.surfels().capacity), count = pencils.positions().size();
    double size = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = c * capacity; i < c * capacity + count; ++i) {
            size += first[i];
            times.difference += std::abs(got[i] - first[i]);
        }
    times.difference /= size;
    std::vector<double> errors;
    for (std::size_t k = 0; k < checked_surfels; ++k) {
        const std::size_t i = k * count / checked_surfels;
        const dvec3 sum(got[i], got[capacity + i], got[2 * capacity + i]);
        errors.push_back(glm::length(sum - map.expected_sum(pencils.positions()[i])) * static_cast<double>(count) / size);
    }
    std::sort(errors.begin(), errors.end());
    times.reference_difference = errors[checked_surfels * 9 / 10];
}

double spent(const LookUpTimes& times) {
    double sum = 0.0;
    for (const double s : times.seconds) sum += s;
    for (const double s : times.footprint_seconds) sum += s;
    return sum;
}

}  // namespace

std::vector<LookUpTimes> time_look_ups(LitPencils& pencils, const std::vector<ref::NamedMap>& maps, int texels, int repeats) {
    std::vector<FilledMap> filled;
    std::vector<LookUpTimes> times(maps.size());
    std::vector<float> first;
    filled.reserve(maps.size());
    for (std::size_t m = 0; m < maps.size(); ++m) {
        filled.emplace_back(pencils, maps[m], texels);
        filled[m].look_up(false);  // builds, and does not count
        filled[m].look_up(true);
        times[m].n = filled[m].n();
        if (m == 0) first = filled[m].sums();
        check(pencils, filled[m], first, times[m]);
    }
    for (int round = 0; round < repeats; ++round)
        for (std::size_t m = 0; m < maps.size(); ++m) {
            if (round > 0 && spent(times[m]) > most_seconds) continue;
            times[m].footprint_seconds.push_back(filled[m].look_up(false));
            times[m].seconds.push_back(filled[m].look_up(true));
        }
    return times;
}

}  // namespace pencil::thesis
