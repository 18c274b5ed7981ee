// Where world sets begin: pencils on the film, whose texels show where light is reflected that matters to it.
#pragma once

#include "surface/film_pixels.h"
#include "surface/surface_pencils.h"

namespace pencil {

/// A pixel of each cell of spacing x spacing pixels that shows something.
std::vector<uint> pixels_of_cells(const FilmPixels& pixels, int spacing);
/// Pixels on which world sets begin, and others between these `seeds`, where a look tells whether they miss anything.
std::vector<uint> seeding_pixels(const FilmPixels& pixels, const Camera& camera);
std::vector<uint> looking_pixels(const FilmPixels& pixels, const Camera& camera, const std::vector<uint>& seeds);
/// Of these so many at most, all over the image.
std::vector<uint> some_of(const std::vector<uint>& pixels, std::size_t most);
/// A pencil on the first surfel of each of these pixels that shows something, with maps of map x map texels; their keys are the pixels.
SurfacePencils seed_pencils(Kernels& kernels, const FilmPixels& pixels, const std::vector<uint>& chosen, int map);
/// Pencils on sensors, several on each where these are few.
SurfacePencils seed_sensors(Kernels& kernels, const Film& film, int map);

}  // namespace pencil
