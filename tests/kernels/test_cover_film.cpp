// Which surfels of the film no pencil of the lattice stands for.
#include "kernels/lattice_test.h"
#include "reference/tolerances.h"
#include "surface/cover_film.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr float most_error = 0.6F;

constexpr unsigned char never_written = 7;

/// By surfel, up to the capacity.
std::vector<unsigned char> uncovered(const MadeFilm& film, float error = most_error) {
    Kernels kernels = make_kernels();
    const DeviceFilm on_film(film);
    Buffer<unsigned char> bytes(device(), std::vector<unsigned char>(static_cast<std::size_t>(film.surfels.capacity), never_written),
                                "uncovered");
    cover_film(kernels, on_film.shown, on_film.lattice, error, bytes);
    return bytes.read();
}

TEST(CoverFilm, IsTheReferences) {
    int compared = 0, covered = 0;
    for (const FilmCase& c : film_cases()) {
        const MadeFilm film(c.width, c.height, c.coarsest, c.finest, 41);
        const std::vector<unsigned char> got = uncovered(film);
        for (int pixel = 0; pixel < c.width * c.height; ++pixel)
            for (int i = film.first_of(pixel); i < film.first_of(pixel) + film.surfels_of(pixel); ++i) {
                const ref::Cover expected =
                    ref::cover(film.lattice(), pixel % c.width, pixel / c.width, film.surfels.position(i), film.surfels.normal(i));
                if (expected.margin < tolerance::decision || std::abs(expected.least / most_error - 1.0) < tolerance::decision) continue;
                ++compared;
                covered += expected.least > most_error ? 0 : 1;
                ASSERT_EQ(got[static_cast<std::size_t>(i)], expected.least > most_error ? 1 : 0)
                    << "surfel " << i << " of pixel " << pixel << ", least error " << expected.least << ", " << name(c);
            }
        for (int i = film.surfels.count; i < film.surfels.capacity; ++i)
            ASSERT_EQ(got[static_cast<std::size_t>(i)], never_written) << "beyond the count";
    }
    EXPECT_GT(compared, 5000);
    EXPECT_GT(covered, 1000);
    EXPECT_GT(compared - covered, 800);
}

/// More error or a finer lattice never covers less.
TEST(CoverFilm, IsMonotone) {
    MadeFilm film(37, 23, 8, 1, 43);
    const std::vector<unsigned char> fine = uncovered(film), generous = uncovered(film, 2 * most_error);
    film.finest = 4;
    const std::vector<unsigned char> coarse = uncovered(film);
    int less = 0;
    for (std::size_t i = 0; i < fine.size(); ++i) {
        EXPECT_LE(fine[i], coarse[i]) << "surfel " << i;
        EXPECT_LE(generous[i], fine[i]) << "surfel " << i;
        less += coarse[i] - fine[i];
    }
    EXPECT_GT(less, 50);
}

TEST(CoverFilm, PermutingPencilsChangesNothing) {
    MadeFilm film(37, 23, 8, 2, 44);
    const std::vector<int> order = shuffled(film.random(), film.pencils.size());
    EXPECT_EQ(uncovered(film), uncovered(renumbered(film, order)));
}

}  // namespace
