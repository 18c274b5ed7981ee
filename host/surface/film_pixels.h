// What the pixels of a film show, on the host: read from the device once per film.
#pragma once

#include <vector>

#include "film/film.h"
#include "shared/film.h"

namespace pencil {

struct FilmPixels {
    explicit FilmPixels(const Film& shown) : film(shown), counts(shown.counts().read()), first_surfel(shown.first_surfel().read()) {}

    /// True if the pixel shows something; its first surfel then is first_surfel[pixel].
    bool shows(std::size_t pixel) const { return surfels(pixel) > 0; }
    int surfels(std::size_t pixel) const { return counts[pixel] & FILM_COUNT_MASK; }
    /// True if each visibility sample has a surfel of its own.
    bool shows_samples(std::size_t pixel) const { return film.samples() > 1 && surfels(pixel) == film.samples(); }

    const Film& film;
    std::vector<unsigned char> counts;
    std::vector<int> first_surfel;
};

}  // namespace pencil
