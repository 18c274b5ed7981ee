// Polygon luminaires and the CIE cube by the pencil renderer: closed forms that the reference path tracer is tested on, too.
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"

namespace {

using namespace pencil;
using namespace pencil::test;

double mean(const Layer& image) {
    double sum = 0.0;
    for (std::size_t i = 0; i < pixel_count(image); ++i) sum += pixel(image, i).x;
    return sum / static_cast<double>(pixel_count(image));
}

TEST(Luminaires, PolygonsByLambertsFormula) {
    for (const Luminaire& luminaire : luminaires()) {
        RenderOptions options = line_options();
        options.initial = Initial::direct;
        options.bounces = 1;
        options.map = 16;  // nothing stands between floor and luminaire
        options.light_samples = 4096;
        const double direct = mean(layer(render_layers(luminaire_scene(luminaire), options, {"direct"}), "direct"));
        std::printf("%s: %.4f of Lambert's formula\n", luminaire.name, direct / luminaire_answer(luminaire));
        EXPECT_NEAR(direct, luminaire_answer(luminaire), 0.01 * luminaire_answer(luminaire)) << luminaire.name;
    }
}

TEST(Luminaires, Cie171Test58) {
    for (const double albedo : {0.2, 0.5, 0.8, 0.9, 0.95}) {
        RenderOptions options = line_options();
        options.tolerance = 1e-4;
        const double wall = mean(layer(render_layers(cie_cube(albedo), options), "")),
                     expected = albedo / ref::pi * cie_cube_answer(albedo);
        std::printf("albedo %.2f: %.4f of the energy balance\n", albedo, wall / expected);
        EXPECT_NEAR(wall, expected, 0.02 * expected) << "albedo " << albedo;
    }
}

}  // namespace
