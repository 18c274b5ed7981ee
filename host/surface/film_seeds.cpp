#include "surface/film_seeds.h"

#include <algorithm>
#include <set>

#include "surface/place_surface_pencils.h"
#include "surface/surface_pass.h"

namespace pencil {

namespace {

/// Spacing of seeds, in terms of the coarsest film pencils of the first pass.
constexpr int seed_spacing = 8;
/// As many pixels look as there are such pencils, but not many more than this, unless seeds are as many.
constexpr int usual_looks = 1 << 14;
/// Of sensors.
constexpr int least_seeds = 256, most_seeds = 1024;

}  // namespace

std::vector<uint> pixels_of_cells(const FilmPixels& pixels, int spacing) {
    const Film& film = pixels.film;
    const int columns = (film.width() + spacing - 1) / spacing, rows = (film.height() + spacing - 1) / spacing;
    std::vector<bool> seeded(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), false);
    std::vector<uint> found;
    for (std::size_t pixel = 0; pixel < pixels.counts.size(); ++pixel) {
        const int x = static_cast<int>(pixel) % film.width(), y = static_cast<int>(pixel) / film.width();
        const auto cell = static_cast<std::size_t>(y / spacing) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x / spacing);
        if (seeded[cell] || !pixels.shows(pixel)) continue;
        seeded[cell] = true;
        found.push_back(static_cast<uint>(pixel));
    }
    return found;
}

std::vector<uint> seeding_pixels(const FilmPixels& pixels, const Camera& camera) {
    return pixels_of_cells(pixels, seed_spacing * coarsest_spacing(camera));
}

std::vector<uint> looking_pixels(const FilmPixels& pixels, const Camera& camera, const std::vector<uint>& seeds) {
    const int coarsest = coarsest_spacing(camera);
    int spacing = coarsest;
    while (2 * spacing<seed_spacing * coarsest&& static_cast<double>(camera.width) * camera.height> static_cast<double>(usual_looks) *
           spacing * spacing)
        spacing *= 2;
    const std::set<uint> known(seeds.begin(), seeds.end());
    std::vector<uint> found = pixels_of_cells(pixels, spacing);
    found.erase(std::remove_if(found.begin(), found.end(), [&](uint pixel) { return known.count(pixel) > 0; }), found.end());
    return found;
}

std::vector<uint> some_of(const std::vector<uint>& pixels, std::size_t most) {
    if (pixels.size() <= most) return pixels;
    std::vector<uint> some(most);
    for (std::size_t k = 0; k < most; ++k) some[k] = pixels[k * pixels.size() / most];
    return some;
}

SurfacePencils seed_pencils(Kernels& kernels, const FilmPixels& pixels, const std::vector<uint>& chosen, int map) {
    ChosenSurfels surfels;
    for (const uint pixel : chosen)
        if (pixels.shows(pixel)) surfels.add(pixels.first_surfel[pixel], pixel, pixels.film.viewer(pixels.first_surfel[pixel]));
    SurfacePencils seeds(kernels.device(), 1, map);
    place_surface_pencils(kernels, pixels.film.surfels(), surfels, seeds);
    return seeds;
}

SurfacePencils seed_sensors(Kernels& kernels, const Film& film, int map) {
    ChosenSurfels chosen;
    const int sensors = film.surfels().count, seeds = std::clamp(sensors, least_seeds, most_seeds);
    for (int k = 0; k < seeds; ++k) {
        const auto sensor = static_cast<int>(static_cast<std::int64_t>(k) * sensors / seeds);
        chosen.add(sensor, static_cast<uint>(k), film.viewer(sensor));
    }
    SurfacePencils pencils(kernels.device(), 1, map);
    place_surface_pencils(kernels, film.surfels(), chosen, pencils);
    return pencils;
}

}  // namespace pencil
