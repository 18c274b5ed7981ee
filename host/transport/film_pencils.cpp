#include "transport/film_pencils.h"

#include <algorithm>

#include "shared/film.h"

namespace pencil {

FilmPencils::FilmPencils(Kernels& kernels, const Film& film, const FilmLattice& lattice)
    : kernels_(kernels),
      film_(film),
      lattice_(lattice),
      counts_(film.counts().read()),
      first_(film.first_surfel().read()),
      at_(counts_.size(), -1),
      pencil_at_(kernels.device(), at_, "film pencils by pixel"),
      pencils_(kernels.device(), 1, lattice.map) {
    std::vector<int> pixels;
    const int width = film.width(), height = film.height(), step = lattice.coarsest;
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
    std::vector<int> chosen;
    int next = pencils_.count;
    for (int pixel : pixels) {
        const auto p = static_cast<std::size_t>(pixel);
        if (at_[p] >= 0 || (counts_[p] & FILM_COUNT_MASK) == 0) continue;
        at_[p] = next++;
        chosen.push_back(first_[p]);
    }
    place_surface_pencils(kernels_, film_.surfels(), chosen, 0.0F, pencils_, static_cast<float>(spacing));
    pencil_at_.write(at_);
}

void FilmPencils::refine(SurfaceSolver& solver) {
    const int width = film_.width(), height = film_.height();
    Buffer<unsigned char> uncovered(kernels_.device(), counts_.size(), "uncovered pixels");
    solver.gather(pencils_, gathered_, pencils_.count - gathered_);
    gathered_ = pencils_.count;
    for (int spacing = lattice_.coarsest; spacing > lattice_.finest && !solver.stopped(); spacing /= 2) {
        kernels_.get("cover_film")
            .args(film_.surfels().data, film_.surfels().capacity, film_.counts(), film_.first_surfel(), pencils_.data, pencil_at_,
                  lattice_.coarsest, spacing, lattice_.most_error, width, height, uncovered)
            .run(counts_.size(), "cover film");
        const std::vector<unsigned char> open = uncovered.read();
        std::vector<int> pixels;
        const int half = spacing / 2;
        std::vector<bool> done(counts_.size(), false);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                if (!open[static_cast<std::size_t>(y * width + x)]) continue;
                const int left = x / spacing * spacing, top = y / spacing * spacing;
                if (done[static_cast<std::size_t>(top * width + left)]) continue;
                done[static_cast<std::size_t>(top * width + left)] = true;
                for (int dy = 0; dy <= 2; ++dy)
                    for (int dx = 0; dx <= 2; ++dx)
                        pixels.push_back(std::min(top + dy * half, height - 1) * width + std::min(left + dx * half, width - 1));
            }
        place(pixels, half);
        solver.gather(pencils_, gathered_, pencils_.count - gathered_);
        gathered_ = pencils_.count;
    }
}

void FilmPencils::project(Buffer<float>& outgoing) {
    const Surfels& surfels = film_.surfels();
    Buffer<float4> irradiance(kernels_.device(), static_cast<std::size_t>(pencils_.count), "irradiance of film pencils");
    kernels_.get("smooth_irradiance")
        .args(pencils_.data, pencil_at_, lattice_.smooth, film_.width(), film_.height(), irradiance)
        .run(counts_.size(), "smooth irradiance");
    kernels_.get("project_film_pencils")
        .args(surfels.data, surfels.capacity, film_.counts(), film_.first_surfel(), pencils_.data, irradiance, pencil_at_,
              lattice_.coarsest, lattice_.finest, 2.0F * lattice_.most_error, film_.width(), film_.height(), outgoing)
        .run(counts_.size(), "project film pencils");
}

}  // namespace pencil
