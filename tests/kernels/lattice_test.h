// A film with pencils on its lattice, made by hand, for the kernels of film pencils.
#pragma once

#include "kernels/surface_test.h"
#include "reference/film_lattice_ref.h"
#include "shared/film.h"
#include "surface/film_lattice.h"

namespace pencil::test {

/// A bumpy surface seen by width x height pixels: 0 to 3 surfels each, pencils on most points of the lattice down to a spacing.
class MadeFilm {
public:
    MadeFilm(int film_width, int film_height, int coarsest_spacing, int finest_spacing, std::uint32_t seed)
        : width(film_width),
          height(film_height),
          coarsest(coarsest_spacing),
          finest(finest_spacing),
          at(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -1),
          surfels(3 * width * height),
          surface_(seed) {
        for (int pixel = 0; pixel < width * height; ++pixel) add_surfels(pixel);
        surfels.count = next_;
        for (int spacing = coarsest; spacing >= finest; spacing /= 2)
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    if ((x % spacing == 0 || x == width - 1) && (y % spacing == 0 || y == height - 1)) add_pencil(y * width + x, spacing);
    }

    ref::Lattice lattice() const { return {pencils, at, width, height, coarsest, finest}; }
    int surfels_of(int pixel) const { return counts[static_cast<std::size_t>(pixel)] & FILM_COUNT_MASK; }
    int first_of(int pixel) const { return first[static_cast<std::size_t>(pixel)]; }
    Random& random() { return surface_.random; }

    int width, height, coarsest, finest;
    std::vector<SurfacePencil> pencils;
    std::vector<int> at;
    MadeSurfels surfels;
    std::vector<unsigned char> counts;
    std::vector<int> first;

private:
    dvec3 place_of(int pixel) {
        dvec3 x = surface_.point();
        x.x = (pixel % width + surface_.random.uniform()) * 0.05;
        x.z = (pixel / width + surface_.random.uniform()) * 0.05;
        return x;
    }
    void add_surfels(int pixel) {
        const int count = surface_.random.index(4);
        first.push_back(next_);
        counts.push_back(static_cast<unsigned char>(count | (surface_.random.uniform() < 0.5 ? FILM_HAS_EMPTY : 0)));
        for (int k = 0; k < count; ++k) surfels.place(next_++, place_of(pixel), surface_.normal(), 0, surface_.random.in_box(0.1, 1));
    }
    void add_pencil(int pixel, int spacing) {
        int& index = at[static_cast<std::size_t>(pixel)];
        if (index >= 0 || surface_.random.uniform() < 0.1) return;
        index = static_cast<int>(pencils.size());
        pencils.push_back(surface_.pencil(place_of(pixel), 0));
        pencils.back().spacing = spacing;
    }

    BumpySurface surface_;
    int next_ = 0;
};

/// The same on the device, as the launchers take it.
struct DeviceFilm {
    explicit DeviceFilm(const MadeFilm& film)
        : surfels(film.surfels.on_device()),
          counts(device(), film.counts, "counts"),
          first(device(), film.first, "first surfels"),
          pencils(on_device(film.pencils)),
          at(device(), film.at, "pencils by pixel"),
          shown{surfels, counts, first, film.width, film.height},
          lattice{pencils, at, film.coarsest, film.finest} {}
    DeviceFilm(const DeviceFilm&) = delete;
    DeviceFilm& operator=(const DeviceFilm&) = delete;

    Surfels surfels;
    Buffer<unsigned char> counts;
    Buffer<int> first;
    SurfacePencils pencils;
    Buffer<int> at;
    FilmSurfels shown;
    PencilLattice lattice;
};

/// The same film whose pencils are numbered otherwise: pencil p was order[p].
inline MadeFilm renumbered(const MadeFilm& film, const std::vector<int>& order) {
    MadeFilm out = film;
    std::vector<int> place(order.size());
    for (std::size_t p = 0; p < order.size(); ++p) {
        out.pencils[p] = film.pencils[static_cast<std::size_t>(order[p])];
        place[static_cast<std::size_t>(order[p])] = static_cast<int>(p);
    }
    for (int& index : out.at) index = index < 0 ? -1 : place[static_cast<std::size_t>(index)];
    return out;
}

/// Sizes of films: one pixel, and sides that are no multiples of a spacing or a work-group.
struct FilmCase {
    int width, height, coarsest, finest;
};
inline const std::vector<FilmCase>& film_cases() {
    static const std::vector<FilmCase> cases{{1, 1, 4, 4}, {7, 5, 4, 1}, {37, 23, 8, 2}, {64, 48, 4, 4}};
    return cases;
}
inline std::string name(const FilmCase& c) {
    return std::to_string(c.width) + "x" + std::to_string(c.height) + " pixels, spacing " + std::to_string(c.coarsest) + " to " +
           std::to_string(c.finest);
}

}  // namespace pencil::test
