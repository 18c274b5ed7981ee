#include "surface/pass_course.h"

#include <cmath>

namespace pencil {

namespace {

/// More than any patience.
constexpr int most_passes = 1 << 24;

}  // namespace

void PassCourse::transfer(Archive& archive) {
    archive(index, film_rays, world_set, placed_by, wish, guess, spacing, thrift, work, placed_split, missed, missed_before, pixel_noise,
            mean_noise, balance, solver);
    if (!archive.reads()) return;
    Archive::expect(index > 0 && index <= most_passes && placed_by >= 0 && placed_by < index, "no passes");
    Archive::expect(thrift >= 0 && thrift <= most_thrift && wish > 0, "no world set");
    for (const double value : {film_rays, work, pixel_noise, mean_noise, static_cast<double>(guess), static_cast<double>(spacing)})
        Archive::expect(std::isfinite(value) && value >= 0, "a number is none");
    Archive::expect(solver.spots.size() <= SPOTS_MOST, "too many bright spots");
    for (const Spot& spot : solver.spots)
        Archive::expect(std::isfinite(glm::length(spot.centre) + spot.radius + spot.weight + spot.emission) && spot.radius >= 0 &&
                            spot.weight >= 0 && spot.emission >= 0,
                        "a bright spot is nowhere");
}

void PassCourse::expect_pixels(std::size_t pixels) const {
    Archive::expect(placed_split.empty() || placed_split.size() == pixels, "pixels of another image are split");
    for (const std::vector<uint>* seeds : {&missed, &missed_before})
        for (const uint pixel : *seeds) Archive::expect(pixel < pixels, "a seed lies outside the image");
}

void transfer_stats(RenderStats& stats, Archive& archive) {
    archive(stats.bounces, stats.residual, stats.passes, stats.world_pencils, stats.film_pencils, stats.film_surfels, stats.converged);
    archive(stats.bounce_solve, stats.warnings, stats.stopped);
}

}  // namespace pencil
