// Maps of light and of densities at sizes of their own: what is even stays even, the size of all is no size of its own, and nothing else changes.
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"
#include "util/error.h"

namespace pencil::test {
namespace {

RenderOptions small_maps(MethodName method, Weights weights) {
    RenderOptions options = line_options();
    options.method = method;
    options.weights = weights;
    options.pencils = 24;
    options.map = 32;
    options.width = 24;
    options.height = 18;
    options.film_samples = 4;
    options.aovs = {};
    return options;
}

std::vector<float> image_by(const Scene& scene, const RenderOptions& options) {
    return render(scene, options, device()).layers.front().pixels;
}

struct SizedForm {
    MethodName method;
    Weights weights;
};

const SizedForm sized_forms[] = {{MethodName::line, Weights::dpdf},
                                 {MethodName::line, Weights::analytic},
                                 {MethodName::line, Weights::voronoi},
                                 {MethodName::hybrid, Weights::dpdf}};

TEST(MapSizes, OfAFurnaceDoNotMatter) {
    for (const SizedForm& form : sized_forms)
        for (const Iterate iterate : {Iterate::fixed, Iterate::levels}) {
            RenderOptions options = small_maps(form.method, form.weights);
            options.initial = Initial::emission;
            options.iterate = iterate;
            options.radiance_map = 8;
            options.density_map = form.method == MethodName::line ? 16 : 0;
            const RenderResult result = render_layers(furnace(0.5F), options);
            expect_uniform(layer(result, ""), 2.0, 2e-3);
        }
}

TEST(MapSizes, ThatOfAllMapsIsNoneOfItsOwn) {
    const Scene scene = room_of_everything();
    for (const SizedForm& form : sized_forms) {
        RenderOptions options = small_maps(form.method, form.weights);
        const std::vector<float> image = image_by(scene, options);
        options.radiance_map = options.map;
        if (form.method == MethodName::line) options.density_map = options.map;
        EXPECT_EQ(image_by(scene, options), image);
    }
}

TEST(MapSizes, CoarserOnesHoldAboutTheSameLight) {
    const Scene scene = room_of_everything();
    const auto mean = [](const std::vector<float>& rgb) {
        double sum = 0;
        for (const float value : rgb) sum += static_cast<double>(value);
        return sum;
    };
    for (const SizedForm& form : sized_forms)
        for (const Iterate iterate : {Iterate::sets, Iterate::levels}) {
            RenderOptions options = small_maps(form.method, form.weights);
            options.iterate = iterate;
            const double all = mean(image_by(scene, options));
            options.radiance_map = 16;
            const double light = mean(image_by(scene, options)) / all;
            EXPECT_NEAR(light, 1.0, 0.03);
            if (form.method != MethodName::line) continue;
            options.radiance_map = 0;
            options.density_map = 8;
            const double density = mean(image_by(scene, options)) / all;
            EXPECT_NEAR(density, 1.0, 0.03);
            std::printf("light %.4f, densities %.4f\n", light, density);
        }
}

TEST(MapSizes, AreNoneAboveThatOfAll) {
    RenderOptions options = small_maps(MethodName::line, Weights::dpdf);
    options.radiance_map = 40;
    EXPECT_THROW(image_by(furnace(0.5F), options), UsageError);
    options.radiance_map = 12;
    EXPECT_THROW(image_by(furnace(0.5F), options), UsageError) << "no multiple of 8";
}

}  // namespace
}  // namespace pencil::test
