// The lit wall at five places of its floor: rendered irradiance over the exact one.
#pragma once

#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"

namespace pencil::test {

struct Place {
    const char* name;
    double x, z;
};
constexpr std::array<Place, 5> places{
    {{"0.5", 0.5, 0.5}, {"0.2", 0.2, 0.5}, {"0.05", 0.05, 0.5}, {"0.01", 0.01, 0.5}, {"corner", 0.02, 0.02}}};

/// Ratio of the rendered to the exact irradiance at the pixels nearest to the places, by maps that carry emission, one reflection.
inline std::array<double, 5> lit_wall_ratios(RenderOptions options) {
    options.initial = Initial::emission;
    options.bounces = 1;
    options.film_samples = 1;
    const RenderResult result = render_layers(lit_wall_box(), options, {"direct", "position"});
    const Layer &direct = layer(result, "direct"), &position = layer(result, "position");
    std::array<double, 5> out{};
    for (std::size_t p = 0; p < places.size(); ++p) {
        std::size_t best = 0;
        double nearest = 1e9;
        for (std::size_t i = 0; i < pixel_count(position); ++i) {
            const double d = glm::distance(pixel(position, i), dvec3(places[p].x, 0.0, places[p].z));
            if (d < nearest) {
                nearest = d;
                best = i;
            }
        }
        EXPECT_LT(nearest, 0.006) << "no pixel at " << places[p].name;
        const dvec3 at = pixel(position, best);
        out[p] = pixel(direct, best).x * ref::pi / ref::lit_wall_irradiance(at.x, at.z);  // albedo 1: E = pi L
    }
    return out;
}

}  // namespace pencil::test
