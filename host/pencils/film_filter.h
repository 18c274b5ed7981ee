// Reconstruction filters as tables: the visibility samples lie at the same places in every pixel, so one table serves the whole film.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "scene/scene.h"

namespace pencil {

/// Positions of the samples inside a pixel, in [0, 1)^2.
std::vector<glm::vec2> film_sample_offsets(int samples, std::uint64_t seed, std::uint64_t turn = 0);

/// Points of the unit disc for the same samples, in an order of their own.
std::vector<glm::vec2> lens_points(int samples, std::uint64_t seed, std::uint64_t turn);

struct FilterTable {
    int reach = 0;               // neighbours on each side
    std::vector<float> weights;  // [(2 reach + 1)^2][samples], rows first
    std::vector<float> totals;   // [(2 reach + 1)^2]
};
FilterTable tabulate_filter(const ReconstructionFilter& filter, const std::vector<glm::vec2>& offsets);

}  // namespace pencil
