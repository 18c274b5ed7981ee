// The film lit by the pencils of its lattice and by single ones.
#include "kernels/lattice_test.h"
#include "reference/tolerances.h"
#include "reference/transport_ref.h"
#include "surface/project_film_pencils.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr float most_error = 0.8F;
constexpr float sent_before = 0.5F;  // what the surfels send before

struct Lighting {
    std::vector<float4> fits;     // three per pencil
    std::vector<float4> singles;  // irradiance
    std::vector<int> single_of;   // by surfel, -1: none
};

/// `constant`: irradiance everywhere, else random values and slopes.
Lighting lighting(MadeFilm& film, bool with_singles, const dvec3& constant = dvec3(0)) {
    Lighting out;
    const bool random = constant == dvec3(0);
    for (std::size_t p = 0; p < film.pencils.size(); ++p)
        for (int k = 0; k < 3; ++k)
            out.fits.push_back(random ? to_float4(k == 0 ? film.random().in_box(0, 4) : film.random().in_box(-10, 10))
                                      : to_float4(k == 0 ? constant : dvec3(0)));
    out.singles = random ? random_irradiance(film.random(), 5) : std::vector<float4>(5, to_float4(constant));
    for (int i = 0; i < film.surfels.capacity; ++i)
        out.single_of.push_back(with_singles && film.random().index(6) == 0 ? film.random().index(5) : -1);
    return out;
}

std::vector<float> project(const MadeFilm& film, const Lighting& light) {
    Kernels kernels = make_kernels();
    const DeviceFilm on_film(film);
    SurfacePencils singles = on_device(random_pencils(1, static_cast<int>(light.singles.size())));
    singles.irradiance.write(light.singles);
    const Buffer<int> single_at(device(), light.single_of, "singles");
    Buffer<float> outgoing = filled_rgb(film.surfels.capacity, sent_before);
    project_film_pencils(kernels, on_film.shown, on_film.lattice, Buffer<float4>(device(), light.fits, "fits"), most_error,
                         {singles, single_at}, outgoing);
    return outgoing.read();
}

/// Moves the first surfel of every pixel to within 1e-4 of the pixel's pencil: its error is as small as counts.
void visit_pencils(MadeFilm& film) {
    for (int pixel = 0; pixel < film.width * film.height; ++pixel) {
        const int index = film.at[static_cast<std::size_t>(pixel)];
        if (index < 0 || film.surfels_of(pixel) == 0) continue;
        const SurfacePencil& p = film.pencils[static_cast<std::size_t>(index)];
        const dvec3 aside = 1e-4 * ref::TangentFrame(xyz(p.normal)).t;
        film.surfels.place(film.first_of(pixel), xyz(p.position) + aside, xyz(p.normal), 0, film.random().in_box(0.1, 1));
    }
}

TEST(ProjectFilmPencils, IsTheReferences) {
    int compared = 0;
    for (const FilmCase& c : film_cases()) {
        MadeFilm film(c.width, c.height, c.coarsest, c.finest, 61);
        visit_pencils(film);
        const Lighting light = lighting(film, true);
        const std::vector<float> got = project(film, light);
        const auto capacity = static_cast<std::size_t>(film.surfels.capacity);
        for (int pixel = 0; pixel < c.width * c.height; ++pixel)
            for (int i = film.first_of(pixel); i < film.first_of(pixel) + film.surfels_of(pixel); ++i) {
                const int single = light.single_of[static_cast<std::size_t>(i)];
                ref::Projected expected = ref::project(film.lattice(), light.fits, pixel % c.width, pixel / c.width,
                                                       film.surfels.position(i), film.surfels.normal(i), most_error);
                if (single >= 0) expected = {xyz(light.singles[static_cast<std::size_t>(single)]), 1.0};
                if (expected.margin < tolerance::decision) continue;
                ++compared;
                expect_close(
                    rgb_at(got, capacity, i), dvec3(sent_before) + ref::scattered_radiance(film.surfels.albedo(i), expected.irradiance),
                    tolerance::interpolation, "surfel " + std::to_string(i) + " of pixel " + std::to_string(pixel) + ", " + name(c));
            }
        for (int i = film.surfels.count; i < film.surfels.capacity; ++i)
            EXPECT_EQ(rgb_at(got, capacity, i), dvec3(sent_before)) << "beyond the count";
    }
    EXPECT_GT(compared, 5000);
}

TEST(ProjectFilmPencils, ConstantIrradianceStaysConstant) {
    MadeFilm film(37, 23, 8, 2, 62);
    const std::vector<float> got = project(film, lighting(film, true, dvec3(2, 3, 4)));
    for (int i = 0; i < film.surfels.count; ++i)
        expect_close(rgb_at(got, static_cast<std::size_t>(film.surfels.capacity), i),
                     dvec3(sent_before) + film.surfels.albedo(i) * dvec3(2, 3, 4) / ref::pi, tolerance::accumulation,
                     "surfel " + std::to_string(i));
}

TEST(ProjectFilmPencils, WithoutPencilsNothingIsAdded) {
    MadeFilm film(7, 5, 4, 1, 63);
    std::fill(film.at.begin(), film.at.end(), -1);
    for (const float value : project(film, lighting(film, false))) EXPECT_EQ(value, sent_before);
}

TEST(ProjectFilmPencils, PermutingPencilsChangesNothing) {
    MadeFilm film(37, 23, 8, 2, 64);
    const Lighting light = lighting(film, true);
    Lighting turned = light;
    const std::vector<int> order = shuffled(film.random(), film.pencils.size());
    for (std::size_t p = 0; p < order.size(); ++p)
        for (std::size_t k = 0; k < 3; ++k) turned.fits[3 * p + k] = light.fits[3 * static_cast<std::size_t>(order[p]) + k];
    EXPECT_EQ(project(film, light), project(renumbered(film, order), turned));
}

}  // namespace
