// Close-ups lie about the samples of their pixels on what the camera sees there, and their means become what the samples show.
#include "film/close_ups.h"
#include "kernels/film_test.h"
#include "kernels/surface_test.h"
#include "pencils/film_filter.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr int film_samples = 4, film_width = 9, film_height = 7;

struct Looked {
    std::vector<int> pixels{0, 31, 40, film_width* film_height - 1};
    std::vector<glm::vec2> offsets = film_sample_offsets(film_samples, 6);
    TestScene scene = box_scene(131);
    TestCamera view = make_camera({0.4, 0.3, -0.6}, {-0.5, -0.3, 1}, {0, 1, 0}, 1.0, film_width, film_height);
    CloseUps close;
};

Looked look(Kernels& kernels, int film_surfels) {
    Looked l;
    const DeviceScene on_device(device(), l.scene.flat, build_bvh(l.scene.flat.triangles));
    const Buffer<glm::vec2> offsets(device(), l.offsets, "offsets");
    l.close = look_closely(kernels, on_device, {l.view.camera, offsets, film_samples}, l.pixels, film_surfels, {3, 5});
    return l;
}

/// Where the camera sees a point [pixels].
dvec2 seen_at(const TestCamera& view, const dvec3& x) {
    const glm::dmat3 basis(view.step_x, view.step_y, view.corner);
    const dvec3 p = glm::inverse(basis) * (x - view.origin);
    return {p.x / p.z, p.y / p.z};
}

TEST(CloseUps, LieAboutTheirSamples) {
    Kernels kernels = make_kernels(false, Weights::dpdf, 0, film_samples);
    const Looked l = look(kernels, 1 << 20);
    ASSERT_EQ(l.close.each, 16);
    const HostSurfels surfels(l.close.surfels);
    ASSERT_EQ(surfels.count, 4 * film_samples * 16);
    for (int i = 0; i < surfels.count; ++i) {
        const int pixel = l.pixels[static_cast<std::size_t>(i / (16 * film_samples))];
        const dvec2 at = seen_at(l.view, surfels.position(i)) - dvec2(pixel % film_width, pixel / film_width);
        EXPECT_TRUE(at.x > -1e-4 && at.x < 1.0001 && at.y > -1e-4 && at.y < 1.0001) << "in its pixel";
        const dvec2 step = at - dvec2(l.offsets[static_cast<std::size_t>(i / 16 % film_samples)]);
        EXPECT_LE(std::max(std::abs(step.x), std::abs(step.y)), 0.25 + 1e-4) << "half of a sample's width, on the same side of the pixel";
        const dvec3 direction = surfels.position(i) - l.view.origin;
        EXPECT_NEAR(ref::nearest_triangle(l.scene.triangles, l.view.origin, direction).t, 1.0, 1e-4) << "on what is nearest";
    }
}

TEST(CloseUps, AreFewerWhereManyPixelsAreLookedAt) {
    Kernels kernels = make_kernels(false, Weights::dpdf, 0, film_samples);
    TestScene scene = box_scene(131);
    const DeviceScene on_device(device(), scene.flat, build_bvh(scene.flat.triangles)), without(device(), scene.flat);
    const TestCamera view = make_camera({0.4, 0.3, -0.6}, {-0.5, -0.3, 1}, {0, 1, 0}, 1.0, 128, 128);
    const Buffer<glm::vec2> offsets(device(), film_sample_offsets(film_samples, 6), "offsets");
    const auto each = [&](const DeviceScene& s, std::size_t pixels, int film_surfels) {
        return look_closely(kernels, s, {view.camera, offsets, film_samples}, std::vector<int>(pixels, 7), film_surfels, {3, 5}).each;
    };
    EXPECT_EQ(each(on_device, 1, 100), 16);
    EXPECT_EQ(each(on_device, 1 << 11, 100), 4);
    EXPECT_EQ(each(on_device, 1 << 13, 100), 0) << "not one each would be left";
    EXPECT_EQ(each(on_device, 1 << 13, 1 << 17), 4) << "a film of many surfels";
    EXPECT_EQ(each(on_device, 0, 100), 0);
    EXPECT_EQ(each(without, 1, 100), 0) << "no hierarchy";
}

TEST(CloseUps, MeansBecomeWhatSamplesShow) {
    Kernels kernels = make_kernels(false, Weights::dpdf, 0, film_samples);
    const Looked l = look(kernels, 1 << 20);
    const auto capacity = static_cast<std::size_t>(l.close.surfels.capacity);
    std::vector<float> values(3 * capacity, -1.0F);
    for (std::size_t c = 0; c < 3; ++c)
        for (int i = 0; i < l.close.surfels.count; ++i)
            values[c * capacity + static_cast<std::size_t>(i)] = static_cast<float>(c) + static_cast<float>(i % 16);
    std::vector<int> first;
    for (int p = 0; p < film_width * film_height; ++p) first.push_back(film_samples * p);
    const int film_surfels = film_samples * film_width * film_height;
    Buffer<float> of_film(device(), std::vector<float>(3 * static_cast<std::size_t>(film_surfels), 100.0F), "film");
    average_close_ups(kernels, l.close, Buffer<int>(device(), first, "first"), Buffer<float>(device(), values, "values"), of_film,
                      film_surfels);
    const std::vector<float> shown = of_film.read();
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const int surfel = static_cast<int>(i) % film_surfels, pixel = surfel / film_samples;
        const bool looked_at = std::find(l.pixels.begin(), l.pixels.end(), pixel) != l.pixels.end();
        EXPECT_FLOAT_EQ(shown[i], looked_at ? static_cast<float>(static_cast<int>(i) / film_surfels) + 7.5F : 100.0F) << i;
    }
}

}  // namespace
