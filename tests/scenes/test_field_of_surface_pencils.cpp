// Fields whose light is that of surface pencils: closed forms, and the same texels as by light paths.
#include "reference/path_tracer.h"
#include "render/render_session.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"
#include "util/error.h"

namespace pencil::test {
namespace {

std::shared_ptr<PencilField> field_at(const std::vector<dvec3>& centres, int orders = endless_orders, int map = 16) {
    auto field = std::make_shared<PencilField>();
    field->map = map;
    field->orders = orders;
    field->centres = centres;
    return field;
}

/// The light of the field's pencils by surface pencils.
RenderResult gathered(const Scene& scene, const std::shared_ptr<PencilField>& field, int rays = 2, const Progress& progress = {}) {
    RenderOptions options;
    options.field = field;
    options.field_rays = rays;
    options.aovs = {};
    return render(scene, options, device(), progress);
}

/// The same by light paths.
std::vector<float> traced(const Scene& scene, const std::shared_ptr<PencilField>& field, int paths) {
    ReferenceOptions options;
    options.field = field;
    options.spp = paths;
    options.max_depth = field->orders < 0 ? -1 : field->orders + 1;
    return trace_paths(scene, options).layers.front().pixels;
}

void expect_everywhere(const std::vector<float>& light, double value, double relative, const std::string& what) {
    ASSERT_FALSE(light.empty());
    for (std::size_t i = 0; i < light.size(); ++i)
        ASSERT_NEAR(static_cast<double>(light[i]), value, relative * value) << what << ", value " << i;
}

TEST(FieldOfSurfacePencils, InAFurnaceIsAGeometricSeries) {
    constexpr double a = 0.8F;
    const std::vector<dvec3> centres{{0.2, 0.1, -0.3}, {-0.9, 0.9, 0.9}, {1.4, -0.95, 0.5}, {0, 0, 0}};
    for (const int orders : {1, 2, 5}) {
        const RenderResult made = gathered(furnace(static_cast<float>(a)), field_at(centres, orders));
        ASSERT_TRUE(made.field);
        expect_everywhere(made.field->light, (a - std::pow(a, orders + 1)) / (1 - a), 1e-3, std::to_string(orders) + " orders");
    }
    const RenderResult made = gathered(furnace(static_cast<float>(a)), field_at(centres));
    expect_everywhere(made.field->light, a / (1 - a), 3e-3, "all orders");
}

/// A lamp in the middle of a sphere: E = I / r^2, of which 1 / (1 - a) is there after all reflections.
TEST(FieldOfSurfacePencils, OfALampInASphere) {
    constexpr double a = 0.5, intensity = 2.0;
    Scene scene;
    add_shape(scene, "sphere", inward_sphere(1.0, 64), {glm::vec3(static_cast<float>(a)), glm::vec3(0.0F), false});
    scene.point_lights.push_back({dvec3(0.0), glm::vec3(static_cast<float>(intensity))});
    look_at(scene, {0.5, 0, 0}, {0, 0, 0.5}, {0, 1, 0}, 60.0, 8, 8);
    for (const int orders : {1, 3, endless_orders}) {
        const RenderResult made = gathered(scene, field_at({{0.3, 0.2, 0.1}, {-0.5, 0.5, 0}, {0, 0, 0.9}, {0.1, 0, 0}}, orders));
        const double series = orders < 0 ? 1 / (1 - a) : (1 - std::pow(a, orders)) / (1 - a);
        expect_everywhere(made.field->light, a * intensity / ref::pi * series, 0.01, std::to_string(orders) + " orders, flat faces");
    }
}

/// Walls of different colours: no turned or mirrored map would pass.
Scene room_of_colours() {
    Scene scene;
    const glm::vec3 colours[6] = {{0.8F, 0.1F, 0.1F}, {0.1F, 0.8F, 0.1F}, {0.2F, 0.2F, 0.8F},
                                  {0.7F, 0.7F, 0.2F}, {0.2F, 0.7F, 0.7F}, {0.6F, 0.3F, 0.6F}};
    for (int wall = 0; wall < 6; ++wall) add_wall(scene, wall, {0, 0, 0}, {1, 1, 1}, {colours[wall], glm::vec3(0.0F), false});
    look_at(scene, {0.9, 0.5, 0.1}, {0.1, 0.4, 0.9}, {0, 1, 0}, 70.0, 32, 32);
    return scene;
}

/// Root mean square of the difference over that of the truth, and the ratio of means.
struct Likeness {
    double difference, ratio;
};

Likeness likeness(const std::vector<float>& light, const std::vector<float>& truth) {
    double square = 0, wrong = 0, sum = 0, all = 0;
    EXPECT_EQ(light.size(), truth.size());
    for (std::size_t i = 0; i < light.size(); ++i) {
        const double a = static_cast<double>(light[i]), b = static_cast<double>(truth[i]);
        square += b * b;
        wrong += (a - b) * (a - b);
        sum += a;
        all += b;
    }
    return {std::sqrt(wrong / square), sum / all};
}

void expect_like_paths(const Scene& scene, const std::shared_ptr<PencilField>& field, int rays, double most_difference,
                       const std::string& what) {
    const RenderResult made = gathered(scene, field, rays);
    ASSERT_TRUE(made.field);
    const Likeness found = likeness(made.field->light, traced(scene, field, 256));
    std::printf("%s: difference %.3f, ratio of means %.4f\n", what.c_str(), found.difference, found.ratio);
    EXPECT_LT(found.difference, most_difference) << what;
    EXPECT_NEAR(found.ratio, 1.0, 0.01) << what;
}

TEST(FieldOfSurfacePencils, HasTheTexelsOfLightPaths) {
    const std::vector<dvec3> centres{{0.5, 0.5, 0.5}, {0.2, 0.8, 0.3}, {0.85, 0.15, 0.6}};
    Scene lamp = room_of_colours(), panel = room_of_colours();
    lamp.point_lights.push_back({{0.3, 0.8, 0.6}, glm::vec3(1.0F)});
    add_quad(panel, "panel", {0.3, 0.95, 0.3}, {0.4, 0, 0}, {0, 0, 0.4}, {glm::vec3(0.2F), glm::vec3(10.0F), false});
    for (const int orders : {2, endless_orders}) {
        expect_like_paths(lamp, field_at(centres, orders), 4, 0.08, "lamp, orders " + std::to_string(orders));
        expect_like_paths(panel, field_at(centres, orders), 4, 0.1, "panel, orders " + std::to_string(orders));
    }
}

/// A mirror shows the panel, which the maps do not show themselves, and the walls.
TEST(FieldOfSurfacePencils, FollowsMirrors) {
    Scene scene = room_of_colours();
    add_quad(scene, "panel", {0.3, 0.95, 0.3}, {0.4, 0, 0}, {0, 0, 0.4}, {glm::vec3(0.2F), glm::vec3(10.0F), false});
    scene.materials.front().model = MATERIAL_CONDUCTOR;
    scene.materials.front().perfect_mirror = true;
    scene.materials.front().specular = glm::vec3(0.9F);
    expect_like_paths(scene, field_at({{0.6, 0.5, 0.5}, {0.2, 0.4, 0.3}}), 24, 0.2, "mirror");
}

TEST(FieldOfSurfacePencils, IsTheSameTwice) {
    const Scene scene = room_of_everything();
    const auto field = field_at({{0.1, 0.1, 0.8}, {-0.6, 0.3, 0.5}});
    EXPECT_EQ(gathered(scene, field, 1).field->light, gathered(scene, field, 1).field->light);
}

TEST(FieldOfSurfacePencils, ThatIsInterruptedIsNone) {
    int calls = 0;
    const RenderResult result =
        gathered(room_of_everything(), field_at({{0.1, 0.1, 0.8}}), 4, [&](const std::string&, double) { return ++calls < 20; });
    EXPECT_TRUE(result.interrupted);
    EXPECT_FALSE(result.field);
}

}  // namespace
}  // namespace pencil::test
