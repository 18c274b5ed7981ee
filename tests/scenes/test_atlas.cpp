// --atlas image and buffer are two ways to the same image.
#include "cl/texel_image.h"
#include "image/relative_error.h"
#include "render/render_session.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"

namespace pencil::test {
namespace {

std::vector<float> beauty_by(Atlas atlas, RenderOptions options, const Scene& scene) {
    options.atlas = atlas;
    options.width = 32;
    options.height = 24;
    options.pencils = 32;
    options.map = 32;
    options.bounces = 3;
    return render_layers(scene, options).layers.front().pixels;
}

void expect_same_by_image(const RenderOptions& options) {
    const Scene scene = room_of_everything();
    const std::vector<float> image = beauty_by(Atlas::image, options, scene), buffer = beauty_by(Atlas::buffer, options, scene);
    double mean = 0, sum = 0;
    for (const float value : buffer) mean += value / static_cast<double>(buffer.size());
    for (std::size_t i = 0; i < buffer.size(); ++i) sum += relative_square(image[i], buffer[i], mean);
    EXPECT_LT(sum / static_cast<double>(buffer.size()), 1e-5);
}

TEST(AtlasForms, GiveTheSameImage) {
    if (image_limits(*device()).layers == 0) GTEST_SKIP() << "no images on " << device()->info().name;
    RenderOptions options = line_options();
    expect_same_by_image(options);
    options.weights = Weights::voronoi;
    options.map_kind = MapKind::cube;
    expect_same_by_image(options);
    options.method = MethodName::hybrid;
    options.map_kind = MapKind::octahedral;
    expect_same_by_image(options);
}

}  // namespace
}  // namespace pencil::test
