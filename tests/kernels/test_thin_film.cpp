// Thin films: which surfels have light of their own, and what the others receive, known in closed form.
#include "kernels/kernel_test.h"
#include "line/thin_film.h"
#include "shared/film.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// A film of one surfel per pixel, in planes of normal z that stand side by side. All reflect half of their light.
struct FlatFilm {
    int width, height;
    Buffer<float> surfels;
    Buffer<unsigned char> counts;
    Buffer<int> first;
    std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
    std::size_t cells() const {
        return static_cast<std::size_t>((width + THIN_STEP - 1) / THIN_STEP) *
               static_cast<std::size_t>((height + THIN_STEP - 1) / THIN_STEP);
    }
    auto arguments() const {
        return std::tuple<const Buffer<float>&, int, const Buffer<unsigned char>&, const Buffer<int>&, int, int>(
            surfels, surfel_capacity(width * height), counts, first, width, height);
    }
};

/// plane_of(x, y): number of the plane that a pixel shows; each lies one unit behind the last.
template <typename PlaneOf>
FlatFilm make_film(int width, int height, PlaneOf plane_of) {
    const auto size = static_cast<std::size_t>(width * height), capacity = static_cast<std::size_t>(surfel_capacity(width * height));
    std::vector<float> data(capacity * SURFEL_FIELDS);
    std::vector<int> first;
    for (std::size_t i = 0; i < size; ++i) {
        const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width, plane = plane_of(x, y);
        first.push_back(static_cast<int>(i));
        data[SURFEL_X * capacity + i] = static_cast<float>(x);
        data[SURFEL_Y * capacity + i] = static_cast<float>(y);
        data[SURFEL_Z * capacity + i] = static_cast<float>(100 * plane);
        data[SURFEL_NZ * capacity + i] = 1.0F;
        std::memcpy(&data[SURFEL_PLANE * capacity + i], &plane, sizeof plane);
        for (std::size_t c = 0; c < 3; ++c) data[(SURFEL_ALBEDO_R + c) * capacity + i] = 0.5F;
    }
    return {width, height, Buffer<float>(device(), data, "surfels"),
            Buffer<unsigned char>(device(), std::vector<unsigned char>(size, 1), "counts"), Buffer<int>(device(), first, "first")};
}

std::vector<unsigned char> own_light(Kernels& kernels, const FlatFilm& film) {
    Buffer<unsigned char> own(device(), static_cast<std::size_t>(surfel_capacity(film.width * film.height)), "own");
    kernels.get("thin_film").args(film.arguments(), own).run(film.cells(), "thin film");
    return own.read(0, film.size());
}

/// Red that the surfels reflect of light_of(x, y), which those with light of their own receive.
template <typename LightOf>
std::vector<float> spread(Kernels& kernels, const FlatFilm& film, LightOf light_of) {
    const std::vector<unsigned char> own = own_light(kernels, film);
    std::vector<int> place;
    std::vector<float> red;
    for (std::size_t i = 0; i < film.size(); ++i) {
        place.push_back(own[i] ? static_cast<int>(red.size()) : -1);
        if (own[i]) red.push_back(light_of(static_cast<int>(i) % film.width, static_cast<int>(i) / film.width));
    }
    const auto picked = static_cast<int>(red.size());
    red.resize(3 * red.size());
    Buffer<float> outgoing = surfel_rgb(device(), surfel_capacity(film.width * film.height), "outgoing");
    kernels.get("spread_light")
        .args(film.arguments(), Buffer<int>(device(), place, "place"), Buffer<float>(device(), red, "picked light"), picked, outgoing)
        .run(film.cells(), "spread light");
    return outgoing.read(0, film.size());
}

TEST(ThinFilm, OfOnePlaneIsALattice) {
    Kernels kernels = make_kernels(false, Weights::dpdf, 0, 4);
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(10, 7), std::pair(13, 16)}) {
        const FlatFilm film = make_film(width, height, [](int, int) { return 0; });
        const std::vector<unsigned char> own = own_light(kernels, film);
        // Beyond the last row and column of the lattice there is nothing to take a mean of: one neighbour is not enough.
        const int last_x = (width - 1) / THIN_STEP * THIN_STEP, last_y = (height - 1) / THIN_STEP * THIN_STEP;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                EXPECT_EQ(own[static_cast<std::size_t>(y * width + x)] != 0,
                          (x % THIN_STEP == 0 && y % THIN_STEP == 0) || (x >= last_x && y >= last_y))
                    << x << ", " << y << " of " << width << " x " << height;
    }
}

TEST(ThinFilm, LinearLightIsKept) {
    Kernels kernels = make_kernels(false, Weights::dpdf, 0, 4);
    const FlatFilm film = make_film(
        13, 10, [](int, int) { return 0; });
    const auto light = [](int x, int y) { return 1.0F + 0.25F * static_cast<float>(x) + 0.5F * static_cast<float>(y); };
    const std::vector<float> red = spread(kernels, film, light);
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x)
            EXPECT_NEAR(red[static_cast<std::size_t>(y * film.width + x)], 0.5F * light(x, y), 1e-5F) << x << ", " << y;
}

TEST(ThinFilm, NothingPassesFromPlaneToPlane) {
    Kernels kernels = make_kernels(false, Weights::dpdf, 0, 4);
    const auto plane_of = [](int x, int y) { return x < 8 ? 0 : y < 5 ? 1 : 2; };
    const FlatFilm film = make_film(19, 16, plane_of);
    const std::vector<float> red = spread(kernels, film, [&](int x, int y) { return 1.0F + static_cast<float>(plane_of(x, y)); });
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x)
            EXPECT_NEAR(red[static_cast<std::size_t>(y * film.width + x)], 0.5F * (1.0F + static_cast<float>(plane_of(x, y))), 1e-5F)
                << x << ", " << y;
}

}  // namespace
