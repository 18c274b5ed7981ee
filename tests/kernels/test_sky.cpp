// The environment on the device: where texels lie, what is behind the film, and that rays and light samples share it without rest.
#include "film/film.h"
#include "image/colour.h"
#include "kernels/film_test.h"
#include "pencils/flat_sky.h"
#include "pencils/light_samples.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr double pi = 3.14159265358979323846;

/// A map of dim texels, some of them a hundred times as bright, turned round an axis that is none of the world's.
Environment turned_map(int width, int height) {
    Random random(31);
    Environment e;
    e.width = width;
    e.height = height;
    e.radiance = glm::vec3(0.5F, 1.0F, 2.0F);
    for (int i = 0; i < width * height; ++i) e.texels.emplace_back((i % 11 == 3 ? 100.0 : 1.0) * random.in_box(0.2, 1.0));
    const glm::dvec3 x = glm::normalize(glm::dvec3(1.0, 0.5, -0.3)), y = glm::normalize(glm::cross(glm::dvec3(0.2, 0.1, 1.0), x));
    e.to_world = glm::dmat3(x, y, glm::cross(x, y));
    return e;
}

struct MadeSky {
    explicit MadeSky(const Environment& e) {
        scene.environment = e;
        sky = flatten_sky(scene, texels);
    }
    Scene scene;
    std::vector<float4> texels;
    Sky sky;
};

/// Place on the map [texels] by the definition of Environment.
dvec2 place(const Environment& e, const dvec3& direction) {
    const dvec3 d = glm::transpose(e.to_world) * direction;
    const double u = std::atan2(d.x, -d.z) / (2 * pi);
    return {(u - std::floor(u)) * e.width, std::acos(std::clamp(d.y, -1.0, 1.0)) / pi * (e.height - 1) + 0.5};
}

dvec3 texel(const Environment& e, int x, int y) {
    const int column = (x % e.width + e.width) % e.width, row = std::clamp(y, 0, e.height - 1);
    return dvec3(e.radiance * e.texels[static_cast<std::size_t>(row * e.width + column)]);
}

dvec3 between(const Environment& e, const dvec3& direction) {
    const dvec2 at = place(e, direction) - 0.5, low = glm::floor(at), f = at - low;
    const int x = static_cast<int>(low.x), y = static_cast<int>(low.y);
    return glm::mix(glm::mix(texel(e, x, y), texel(e, x + 1, y), f.x), glm::mix(texel(e, x, y + 1), texel(e, x + 1, y + 1), f.x), f.y);
}

struct SkyValue {
    dvec3 seen, radiance;
};
std::vector<SkyValue> values(const MadeSky& made, const std::vector<dvec3>& directions, double density) {
    std::vector<float4> d;
    for (const dvec3& v : directions) d.push_back(to_float4(v, density));
    ProgramCache programs(device());
    Buffer<float4> out(device(), 2 * d.size(), "values");
    programs.kernel("sky_values", PENCIL_SOURCE_DIR "/tests/kernels/test_sky.cl")
        .args(Buffer<Sky>(device(), {made.sky}, "sky"), Buffer<float4>(device(), made.texels, "texels"),
              Buffer<float4>(device(), d, "directions"), static_cast<int>(d.size()), out)
        .run(d.size(), "sky values");
    const std::vector<float4> found = out.read();
    std::vector<SkyValue> result;
    for (std::size_t i = 0; i < d.size(); ++i) result.push_back({xyz(found[2 * i]), xyz(found[2 * i + 1])});
    return result;
}

/// Directions of equal solid angle.
std::vector<dvec3> around(int rings, int sectors) {
    std::vector<dvec3> out;
    for (int r = 0; r < rings; ++r)
        for (int s = 0; s < sectors; ++s) {
            const double z = 1.0 - 2.0 * (r + 0.5) / rings, w = std::sqrt(1.0 - z * z), phi = 2 * pi * (s + 0.5) / sectors;
            out.emplace_back(w * std::cos(phi), w * std::sin(phi), z);
        }
    return out;
}

TEST(SkyKernel, IsTheMap) {
    const Environment e = turned_map(8, 4);
    const MadeSky made(e);
    const std::vector<dvec3> directions = around(40, 40);
    const std::vector<SkyValue> found = values(made, directions, 0.0);
    int different = 0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const dvec2 at = place(e, directions[i]);
        EXPECT_LT(glm::distance(found[i].seen, between(e, directions[i])), 1e-3 * 300.0);
        different += glm::distance(found[i].radiance, texel(e, static_cast<int>(at.x), static_cast<int>(at.y))) > 1e-3 ? 1 : 0;
    }
    EXPECT_LE(different, 2) << "on edges of texels";
}

TEST(SkyKernel, RaysAndLightSamplesShareIt) {
    const MadeSky made(turned_map(8, 4));
    const std::vector<dvec3> directions = around(300, 300);
    const double each = 4 * pi / static_cast<double>(directions.size());
    dvec3 all(0), rays(0), shared(0);
    for (const SkyValue& v : values(made, directions, 0.0)) all += each * v.radiance;
    for (const SkyValue& v : values(made, directions, -1.0)) rays += each * v.radiance;
    std::vector<LightSample> samples;
    sample_sky(made.sky, made.texels, 4000, 0, 0, samples);
    EXPECT_EQ(samples.size(), 4000U);
    dvec3 sampled(0);
    for (const LightSample& s : samples) sampled += xyz(s.emission);
    EXPECT_GT(sampled.y, 0.2 * all.y);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR((rays[c] + sampled[c]) / all[c], 1.0, 3e-3) << c;
    // Scattered rays of even density per light sample, and samples that are weighed against them.
    const double density = 0.3;
    for (const SkyValue& v : values(made, directions, density)) shared += each * v.radiance;
    for (const LightSample& s : samples) shared += xyz(s.emission) * (1.0 / (1.0 + density * static_cast<double>(s.normal.w) * 4000.0));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(shared[c] / all[c], 1.0, 5e-3) << c;
}

TEST(SkyKernel, IsBehindTheFilm) {
    const Environment e = turned_map(8, 4);
    const MadeSky made(e);
    const TestCamera view = make_camera({0, 0, 0}, {0.3, -0.4, 1}, {0, 1, 0}, 1.2, 17, 11);
    TestScene scene = make_scene({{dvec3(-0.1, -0.1, -0.5), dvec3(0.1, -0.1, -0.5), dvec3(0, 0.1, -0.5), 0}}, 1, 5);  // behind the camera
    scene.flat.to_film = view.to_film;
    scene.flat.sky = made.sky;
    scene.flat.sky_texels = made.texels;
    Features features;
    features.film_samples = 4;
    features.sky = features.far_light = true;
    Kernels kernels(device(), features);
    const DeviceScene on_device(device(), scene.flat);
    const Film film(kernels, on_device, FilmCamera{view.camera, glm::vec3(0)}, ReconstructionFilter{}, Turn{});
    const std::vector<float> image = film.sky(kernels, on_device).read();
    const std::vector<glm::vec2> offsets = film_sample_offsets(4, Turn{}.seed, Turn{}.index);
    for (int p = 0; p < 17 * 11; ++p) {
        dvec3 mean(0);
        for (const glm::vec2& o : offsets)
            mean += 0.25 * between(e, glm::normalize(view.direction(p % 17 + static_cast<double>(o.x), p / 17 + static_cast<double>(o.y))));
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(image[static_cast<std::size_t>(3 * p + c)], mean[c], 1e-3 * std::max(mean[c], 1.0)) << "pixel " << p;
    }
}

}  // namespace
