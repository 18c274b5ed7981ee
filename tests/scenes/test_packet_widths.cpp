// How many surfels a work-item takes is a matter of speed: images agree beyond rounding at every width.
#include <cstdlib>

#include "image/relative_error.h"
#include "render/render_session.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"

namespace pencil::test {
namespace {

std::vector<float> beauty_at(const char* width, const Scene& scene, MethodName method) {
    setenv("PENCIL_WIDTH", width, 1);
    const std::shared_ptr<Device> narrow = Device::open("");
    unsetenv("PENCIL_WIDTH");
    RenderOptions options;
    options.method = method;
    options.width = 32;
    options.height = 24;
    options.target_error = 1;
    if (method != MethodName::surface) options.pencils = 64;
    if (method == MethodName::hybrid) options.pencils = 16, options.map = 32, options.bounces = 4;
    RenderSession session(scene, options, narrow);
    while (session.advance()) {
    }
    return session.snapshot().front().pixels;
}

/// relMSE between renders, channel by channel.
double difference(const std::vector<float>& a, const std::vector<float>& b) {
    double mean = 0, sum = 0;
    for (const float value : b) mean += value / static_cast<double>(b.size());
    for (std::size_t i = 0; i < b.size(); ++i) sum += relative_square(a[i], b[i], mean);
    return sum / static_cast<double>(b.size());
}

void expect_the_same_image(MethodName method) {
    const Scene scene = room_of_everything();
    const std::vector<float> wide = beauty_at("16", scene, method);
    for (const char* width : {"8", "4", "1"}) EXPECT_LT(difference(beauty_at(width, scene, method), wide), 1e-5) << width;
}

TEST(PacketWidths, GiveTheSameImageBySurfacePencils) { expect_the_same_image(MethodName::surface); }

TEST(PacketWidths, GiveTheSameImageByLines) { expect_the_same_image(MethodName::line); }

TEST(PacketWidths, GiveTheSameImageByLinesAndRays) { expect_the_same_image(MethodName::hybrid); }

}  // namespace
}  // namespace pencil::test
