// Visibility samples of a film drawn in proportion to their weight in a pixel, on the host.
#pragma once

#include <vector>

#include "film/film.h"

namespace pencil {

class FilmDraws {
public:
    explicit FilmDraws(const Film& film);

    struct Draw {
        int surfel;    // -1: the sample shows nothing
        float weight;  // of its radiance: the mean of weight * radiance over draws is the pixel; negative in negative lobes of the filter
    };
    /// `count` draws for a pixel, stratified; u in [0, 1).
    std::vector<Draw> draw(std::size_t pixel, int count, double u) const;

private:
    const Film& film_;
    std::vector<unsigned char> slots_, drawn_;
    std::vector<int> first_surfel_;
};

}  // namespace pencil
