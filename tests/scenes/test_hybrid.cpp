// Lines and rays together against closed forms and the path tracer: where lines alone are far off.
#include "reference/path_tracer.h"
#include "scenes/lit_wall.h"
#include "util/error.h"

namespace pencil::test {
namespace {

RenderOptions hybrid_options() {
    RenderOptions options = line_options();
    options.method = MethodName::hybrid;
    options.pencils = 64;
    options.map = 32;
    return options;
}

dvec3 mean_of(const Layer& image) {
    dvec3 sum(0.0);
    for (std::size_t i = 0; i < pixel_count(image); ++i) sum += pixel(image, i) / static_cast<double>(pixel_count(image));
    return sum;
}

TEST(Hybrid, LitWallIsRightIntoTheCorner) {
    std::array<double, 5> mean{};
    constexpr int seeds = 6;
    for (int seed = 0; seed < seeds; ++seed) {
        RenderOptions options = hybrid_options();
        options.pencils = 128;
        options.seed = static_cast<std::uint64_t>(seed);
        const std::array<double, 5> ratios = lit_wall_ratios(options);
        for (std::size_t p = 0; p < ratios.size(); ++p) mean[p] += ratios[p] / seeds;
    }
    // One pixel each: 64 rays that meet the wall or not. Lines alone have 0.03 to 0.4 of the light near the wall.
    for (std::size_t p = 0; p < places.size(); ++p) {
        std::printf("%s from the lit wall: %.3f\n", places[p].name, mean[p]);
        EXPECT_NEAR(mean[p], 1.0, p == 0 ? 0.04 : 0.08) << places[p].name;
    }
}

/// albedo^k in every pixel and channel.
void expect_power(const Layer& image, const glm::vec3& albedo, int k) {
    for (std::size_t i = 0; i < pixel_count(image); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(pixel(image, i)[c] / std::pow(static_cast<double>(albedo[c]), k), 1.0, 2e-4) << image.name << ", pixel " << i;
}

TEST(Hybrid, FurnaceIsExact) {
    Scene scene = furnace(0.0F);
    const glm::vec3 albedo(0.9F, 0.6F, 0.25F);
    for (SceneMaterial& material : scene.materials) material.albedo = albedo;
    for (const int pencils : {1, 16, 150})
        for (const Iterate iterate : {Iterate::sets, Iterate::fixed}) {
            RenderOptions options = hybrid_options();
            options.initial = Initial::emission;
            options.iterate = iterate;
            options.pencils = pencils;
            options.map = pencils == 1 ? 32 : 8;
            options.rays = 64;
            options.width = 16;
            options.height = 12;
            options.film_samples = 4;
            options.bounces = 6;
            const RenderResult result = render_layers(scene, options, {"direct", "bounces"});
            expect_power(layer(result, "direct"), albedo, 1);
            for (int k = 2; k <= options.bounces; ++k) expect_power(layer(result, "bounce" + std::to_string(k)), albedo, k);
            options.bounces = endless_bounces;
            options.tolerance = 1e-3;
            const Layer image = layer(render_layers(scene, options), "");
            for (std::size_t i = 0; i < pixel_count(image); ++i)
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(pixel(image, i)[c] * (1.0 - static_cast<double>(albedo[c])), 1.0, 1e-3)
                        << pencils << " pencils: a few of 10^5 texels are dark, in corners";
        }
}

/// A ball seen from inside whose triangles are wide and whose shading is round, a light beside its middle.
TEST(Hybrid, SmoothShadingIsThatOfLightPaths) {
    Scene scene;
    add_shape(scene, "ball", inward_sphere(1.0, 8), {{0.8F, 0.5F, 0.3F}, glm::vec3(0.0F), false});
    for (std::size_t i = 0; i < scene.positions.size(); ++i) scene.normals[i] = glm::vec3(-glm::normalize(scene.positions[i]));
    scene.point_lights.push_back({{0.5, 0.3, 0.1}, glm::vec3(1.0F)});
    look_at(scene, {-0.5, 0.1, -0.2}, {0.6, -0.2, 0.3}, {0, 1, 0}, 80.0, 24, 24);
    ReferenceOptions reference;
    reference.spp = 512;
    reference.max_depth = 4;
    reference.bounces = true;
    const ReferenceResult truth = trace_paths(scene, reference);
    RenderOptions options = hybrid_options();
    options.bounces = 3;
    const RenderResult result = render_layers(scene, options, {"bounces"});
    for (const std::string name : {"bounce2", "bounce3"}) {
        const dvec3 ratio = mean_of(layer(result, name)) / mean_of(layer(truth.layers, name));
        std::printf("smooth ball, %s over light paths: %.3f %.3f %.3f\n", name.c_str(), ratio.x, ratio.y, ratio.z);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(ratio[c], 1.0, 0.04) << name;
    }
}

TEST(Hybrid, AdviceNamesNoOptionThatItDoesNotKnow) {
    RenderOptions options = hybrid_options();
    options.placement = {Placement::camera_rays};
    try {
        render(lit_wall_box(), options, device());
        FAIL() << "was rendered";
    } catch (const UsageError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("--method hybrid"), std::string::npos) << text;
        EXPECT_EQ(text.find("--weights"), std::string::npos) << text;
    }
}

/// Two rooms with a sheet between them that has a door: five quads in one plane. All light of the film's room comes through the door.
/// `split`: parts of each side of a quad.
Scene rooms_with_a_door(int split = 1) {
    Scene scene = two_rooms(0.1, true);
    const Surface white{glm::vec3(0.8F), glm::vec3(0.0F), false}, white_both{glm::vec3(0.8F), glm::vec3(0.0F), true};
    Scene open;
    add_box(open, {0, 0, 0}, {2, 1, 1}, white);
    const auto face = [split](double low_y, double high_y, double low_z, double high_z, std::vector<Face>& faces) {
        for (int part = 0; part < split * split; ++part) {
            const double step_y = (high_y - low_y) / split, step_z = (high_z - low_z) / split;
            const double y0 = low_y + step_y * (part / split), y1 = y0 + step_y, z0 = low_z + step_z * (part % split), z1 = z0 + step_z;
            faces.push_back({dvec3(1, y0, z0), dvec3(1, y1, z0), dvec3(1, y1, z1)});
            faces.push_back({dvec3(1, y0, z0), dvec3(1, y1, z1), dvec3(1, y0, z1)});
        }
    };
    std::vector<Face> faces;
    face(-0.01, 0.7, -0.01, 0.5, faces);
    face(-0.01, 0.7, 0.8, 1.01, faces);
    face(0.7, 1.01, -0.01, 0.5, faces);
    face(0.7, 1.01, 0.5, 0.8, faces);
    face(0.7, 1.01, 0.8, 1.01, faces);
    add_shape(open, "wall with a door", faces, white_both);
    add_quad(open, "lamp", {0.3, 0.95, 0.3}, {0.4, 0, 0}, {0, 0, 0.4}, {glm::vec3(0.0F), glm::vec3(10.0F), false});
    open.sensor = scene.sensor;
    return open;
}

TEST(Hybrid, LightThroughADoorIsThatOfLightPaths) {
    const Scene scene = rooms_with_a_door();
    ReferenceOptions reference;
    reference.spp = 1024;
    reference.width = reference.height = 24;
    reference.max_depth = 4;
    const dvec3 truth = mean_of(trace_paths(scene, reference).layers.front());
    double mean = 0.0;
    constexpr int seeds = 3;
    for (int seed = 0; seed < seeds; ++seed) {
        RenderOptions options = hybrid_options();
        options.map = 64;
        options.width = options.height = 24;
        options.bounces = 3;
        options.seed = static_cast<std::uint64_t>(seed);
        mean += mean_of(layer(render_layers(scene, options), "")).x / truth.x / seeds;
    }
    std::printf("behind a door, hybrid over light paths: %.3f\n", mean);
    EXPECT_NEAR(mean, 1.0, 0.05) << "lines alone: 1.4 to 1.6";
}

TEST(Hybrid, AFinelySplitWallHidesAsMuchAsAPlainOne) {
    double means[2] = {0, 0};
    for (const int split : {1, 4}) {
        RenderOptions options = line_options();
        options.weights = Weights::voronoi;
        options.width = options.height = 24;
        options.bounces = 3;
        means[split / 4] = mean_of(layer(render_layers(rooms_with_a_door(split), options), "")).x;
    }
    std::printf("160 triangles over 10: %.4f\n", means[1] / means[0]);
    EXPECT_NEAR(means[1] / means[0], 1.0, 0.02) << "a group of mates that ends too early lets light past the door's edges";
}

TEST(Hybrid, OnePencilIsASet) {
    const Scene scene = lit_wall_box();
    ReferenceOptions reference;
    reference.spp = 256;
    reference.width = reference.height = 24;
    reference.max_depth = 3;
    const double truth = mean_of(trace_paths(scene, reference).layers.front()).x;
    double mean = 0.0;
    constexpr int seeds = 8;
    for (int seed = 0; seed < seeds; ++seed) {
        RenderOptions options = hybrid_options();
        options.pencils = 1;
        options.bounces = 2;
        options.width = options.height = 24;
        options.seed = static_cast<std::uint64_t>(seed);
        mean += mean_of(layer(render_layers(scene, options), "")).x / truth / seeds;
    }
    std::printf("one pencil, hybrid over light paths: %.3f\n", mean);
    EXPECT_NEAR(mean, 1.0, 0.05);
}

}  // namespace
}  // namespace pencil::test
