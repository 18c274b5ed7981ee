// Lines and rays together against closed forms and the path tracer: where lines alone are far off.
#include "reference/path_tracer.h"
#include "scenes/lit_wall.h"

namespace pencil::test {
namespace {

RenderOptions hybrid_options() {
    RenderOptions options = line_options();
    options.method = MethodName::hybrid;
    options.pencils = 64;
    options.map = 32;
    return options;
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

TEST(Hybrid, FurnaceIsExact) {
    RenderOptions options = hybrid_options();
    options.initial = Initial::emission;
    options.film_samples = 4;
    options.bounces = 3;
    const double a = 0.8F;
    const RenderResult result = render_layers(furnace(0.8F), options, {"bounces"});
    for (int k = 2; k <= 3; ++k) expect_uniform(layer(result, "bounce" + std::to_string(k)), std::pow(a, k), 1e-3);
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

dvec3 mean_of(const Layer& image) {
    dvec3 sum(0.0);
    for (std::size_t i = 0; i < pixel_count(image); ++i) sum += pixel(image, i) / static_cast<double>(pixel_count(image));
    return sum;
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
