#include "surface/film_pencils.h"

#include <algorithm>

#include "surface/cover_film.h"
#include "surface/limit_reuse.h"
#include "surface/place_surface_pencils.h"
#include "surface/project_film_pencils.h"
#include "surface/smooth_irradiance.h"

namespace pencil {

namespace {

/// Width of the maps of single pencils: there are many of them where much is small, and no other pencil needs what they know.
constexpr int single_map = 4;
/// A level of the lattice that would have more points than this share of the pixels is left to single pencils: where so little reaches so
/// little, neighbours do not help each other.
constexpr double most_new = 0.2;
/// Pencils fade out at so many times the error up to which one covers a surfel: no edge shows where a surfel leaves the reach of one.
constexpr float fade_errors = 2;

}  // namespace

FilmPencils::FilmPencils(Kernels& kernels, const FilmPixels& film_pixels, const FilmLattice& lattice)
    : kernels_(kernels),
      pixels_(film_pixels),
      film_(film_pixels.film),
      lattice_(lattice),
      at_(film_pixels.counts.size(), -1),
      pencil_at_(kernels.device(), at_, "film pencils by pixel"),
      pencils_(kernels.device(), 1, lattice.map),
      singles_(kernels.device(), 1, lattice.coarsest > 0 ? single_map : lattice.map),
      single_at_(kernels.device(), std::vector<int>(static_cast<std::size_t>(film_.surfels().capacity), -1),
                 "single film pencils by surfel") {
    if (has_lattice()) place_coarsest();
}

void FilmPencils::place_coarsest() {
    std::vector<int> pixels;
    const int width = film_.width(), height = film_.height(), step = lattice_.coarsest;
    for (int y = 0;; y = std::min(y + step, height - 1)) {
        for (int x = 0;; x = std::min(x + step, width - 1)) {
            pixels.push_back(y * width + x);
            if (x == width - 1) break;
        }
        if (y == height - 1) break;
    }
    place(pixels, step);
}

/// Pencils on the first surface of each pixel; pixels that show nothing or have one already get none.
void FilmPencils::place(const std::vector<int>& pixels, int spacing) {
    ChosenSurfels chosen;
    int next = pencils_.count;
    for (int pixel : pixels) {
        const auto p = static_cast<std::size_t>(pixel);
        if (at_[p] >= 0 || !pixels_.shows(p)) continue;
        at_[p] = next++;
        chosen.add(pixels_.first_surfel[p], static_cast<uint>(pixel), film_.viewer(pixels_.first_surfel[p]));
    }
    place_surface_pencils(kernels_, film_.surfels(), chosen, pencils_, spacing);
    pencil_at_.write(at_);
}

/// Surfels that the lattice down to `spacing` leaves uncovered.
std::vector<unsigned char> FilmPencils::uncovered(int spacing) {
    const Surfels& surfels = film_.surfels();
    Buffer<unsigned char> uncovered(kernels_.device(), static_cast<std::size_t>(surfels.capacity), "uncovered surfels");
    cover_film(kernels_, film_surfels(), lattice(spacing), lattice_.most_error, uncovered);
    return uncovered.read(0, static_cast<std::size_t>(surfels.count));
}

/// New lattice points, at half the spacing, of all cells that hold uncovered surfels.
std::vector<int> FilmPencils::finer_pixels(const std::vector<unsigned char>& uncovered, int spacing) const {
    const auto width = static_cast<std::size_t>(film_.width()), height = static_cast<std::size_t>(film_.height()),
               step = static_cast<std::size_t>(spacing);
    std::vector<bool> wanted(at_.size(), false);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t pixel = y * width + x;
            const auto first = uncovered.begin() + pixels_.first_surfel[pixel], last = first + pixels_.surfels(pixel);
            if (std::find(first, last, 1) == last) continue;
            const std::size_t left = x / step * step, top = y / step * step;
            for (std::size_t py = top; py <= top + step; py += step / 2)
                for (std::size_t px = left; px <= left + step; px += step / 2)
                    wanted[std::min(py, height - 1) * width + std::min(px, width - 1)] = true;
        }
    std::vector<int> pixels;
    for (std::size_t p = 0; p < wanted.size(); ++p)
        if (wanted[p] && at_[p] < 0) pixels.push_back(static_cast<int>(p));
    return pixels;
}

void FilmPencils::refine(SurfaceSolver& solver, const TexelPoints& points) {
    if (has_lattice()) refine_lattice(solver, points);
    if (solver.stopped()) return;
    place_singles(has_lattice() ? uncovered(finest_) : std::vector<unsigned char>(static_cast<std::size_t>(film_.surfels().count), 1));
    solver.gather(singles_, 0, singles_.count, points, Reach::own);
}

void FilmPencils::refine_lattice(SurfaceSolver& solver, const TexelPoints& points) {
    const auto gather = [&](int spacing) {
        solver.gather(pencils_, gathered_, pencils_.count - gathered_, points, Reach::others);
        limit_reuse(kernels_, pencils_, pencil_at_, spacing, gathered_, film_.width(), film_.height());
        gathered_ = pencils_.count;
    };
    gather(lattice_.coarsest);
    for (int spacing = lattice_.coarsest; spacing > 1 && !solver.stopped(); spacing /= 2) {
        const std::vector<int> pixels = finer_pixels(uncovered(spacing), spacing);
        if (static_cast<double>(pixels.size()) > most_new * static_cast<double>(at_.size())) {
            finest_ = spacing;
            break;
        }
        place(pixels, spacing / 2);
        gather(spacing / 2);
    }
}

/// A pencil for each uncovered surfel: at silhouettes, in creases and on small things. Pixels whose samples have a surfel each, as those that
/// are split, are covered whole or not at all: pencils of a lattice reach further from where a lamp close by is faint than from where it is
/// bright, so one smaller than a pixel would lose light.
void FilmPencils::place_singles(const std::vector<unsigned char>& uncovered) {
    ChosenSurfels chosen;
    std::vector<int> at(uncovered.size(), -1);
    for (std::size_t pixel = 0; pixel < at_.size(); ++pixel) {
        const auto first = uncovered.begin() + pixels_.first_surfel[pixel];
        const bool all =
            pixels_.shows_samples(pixel) && std::find(first, first + pixels_.surfels(pixel), 1) != first + pixels_.surfels(pixel);
        for (int k = 0; k < pixels_.surfels(pixel); ++k) {
            const int i = pixels_.first_surfel[pixel] + k;
            if (!all && !uncovered[static_cast<std::size_t>(i)]) continue;
            at[static_cast<std::size_t>(i)] = static_cast<int>(chosen.surfels.size());
            chosen.add(i, static_cast<uint>(pixel + static_cast<std::size_t>(k + 1) * at_.size()), film_.viewer(i));
        }
    }
    place_surface_pencils(kernels_, film_.surfels(), chosen, singles_);
    single_at_.write(at);
}

void FilmPencils::project(Buffer<float>& outgoing) {
    Buffer<float4> fits(kernels_.device(), 3 * std::max<std::size_t>(static_cast<std::size_t>(pencils_.count), 1),
                        "irradiance of film pencils");
    if (has_lattice()) smooth_irradiance(kernels_, lattice(finest_), lattice_.smooth, film_.width(), film_.height(), fits);
    project_film_pencils(kernels_, film_surfels(), lattice(finest_), fits, fade_errors * lattice_.most_error, {singles_, single_at_},
                         outgoing);
}

}  // namespace pencil
