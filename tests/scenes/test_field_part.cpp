// Views that use a part of a field: what they see decides which, and the light is that of the whole.
#include "reference/path_tracer.h"
#include "render/render_session.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"

namespace pencil::test {
namespace {

/// A field in memory, that counts how often it is asked.
class CountingSource : public FieldSource {
public:
    explicit CountingSource(std::shared_ptr<const PencilField> field) : field_(std::move(field)) {}
    std::vector<float> light(int pencil) override {
        ++asked[pencil];
        std::vector<float> light;
        for (int y = 0; y < field_->map; ++y)
            for (int x = 0; x < field_->map; ++x)
                for (std::size_t c = 0; c < 3; ++c) light.push_back(field_->light[field_->index(pencil, x, y) + c]);
        return light;
    }
    std::map<int, int> asked;

private:
    std::shared_ptr<const PencilField> field_;
};

/// Two rooms without a door, a lamp in each.
Scene both_rooms_lit() {
    Scene scene = two_rooms(0.0, false);
    scene.point_lights.push_back({{1.5, 0.9, 0.5}, glm::vec3(4.0F)});
    return scene;
}

void look_from(Scene& scene, bool left) {
    look_at(scene, {left ? 0.1 : 1.9, 0.5, 0.1}, {left ? 0.9 : 1.1, 0.45, 0.9}, {0, 1, 0}, 80.0, 32, 32);
}

/// Pencils of both rooms with light by light paths.
std::shared_ptr<PencilField> field_of_rooms(const Scene& scene, int pencils) {
    auto field = std::make_shared<PencilField>();
    field->map = 16;
    for (int i = 2; i < pencils + 2; ++i) {  // Halton's points but for the first, which lies on the wall
        const auto radical = [](int index, int base) {
            double value = 0, step = 1;
            for (; index > 0; index /= base) value += (step /= base) * (index % base);
            return value;
        };
        field->centres.emplace_back(0.01 + 1.98 * radical(i, 2), 0.01 + 0.98 * radical(i, 3), 0.01 + 0.98 * radical(i, 5));
    }
    ReferenceOptions paths;
    paths.field = field;
    paths.spp = 32;
    paths.max_depth = -1;
    auto lit = std::make_shared<PencilField>(*field);
    lit->light = trace_paths(scene, paths).layers.front().pixels;
    return lit;
}

RenderOptions options_of(const std::shared_ptr<PencilField>& field, MethodName method) {
    RenderOptions options;
    options.method = method;
    options.weights = Weights::analytic;
    options.field = field;
    options.width = options.height = 32;
    options.aovs = {};
    return options;
}

/// Those with a part of the field.
RenderOptions part_of(const std::shared_ptr<PencilField>& field, const std::shared_ptr<FieldSource>& source, int pencils,
                      MethodName method) {
    RenderOptions options = options_of(field, method);
    auto head = std::make_shared<PencilField>(*field);
    head->light = {};
    options.field = head;
    options.field_source = source;
    options.field_pencils = pencils;
    return options;
}

std::vector<float> image_of_part(const Scene& scene, const RenderOptions& options) {
    return render(scene, options, device()).layers.front().pixels;
}

double mean_of_image(const std::vector<float>& rgb) {
    double sum = 0;
    for (const float value : rgb) sum += static_cast<double>(value);
    return sum / static_cast<double>(rgb.size());
}

double image_difference(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(static_cast<double>(a[i] - b[i]));
    return sum / static_cast<double>(a.size()) / mean_of_image(b);
}

TEST(FieldPart, OfAllThatTheFilmSeesIsTheWhole) {
    Scene scene = both_rooms_lit();
    look_from(scene, false);
    const auto field = field_of_rooms(scene, 64);
    const int in_view =
        static_cast<int>(std::count_if(field->centres.begin(), field->centres.end(), [](const dvec3& c) { return c.x > 1; }));
    ASSERT_LT(in_view, 40);
    auto source = std::make_shared<CountingSource>(field);
    const RenderOptions line = part_of(field, source, in_view, MethodName::line);
    EXPECT_LT(image_difference(image_of_part(scene, line), image_of_part(scene, options_of(field, MethodName::line))), 0.01)
        << "but for the bound of weights, which is relative to the density in the volume";
    EXPECT_EQ(static_cast<int>(source->asked.size()), in_view);
    for (const auto& [pencil, times] : source->asked) EXPECT_GT(field->centres[static_cast<std::size_t>(pencil)].x, 1.0);
    const RenderOptions hybrid = part_of(field, source, in_view, MethodName::hybrid);
    EXPECT_LT(image_difference(image_of_part(scene, hybrid), image_of_part(scene, options_of(field, MethodName::hybrid))), 0.01);
}

TEST(FieldPart, OfFewerHasTheSameLightInTheMean) {
    Scene scene = both_rooms_lit();
    look_from(scene, false);
    const auto field = field_of_rooms(scene, 128);
    auto source = std::make_shared<CountingSource>(field);
    for (const MethodName method : {MethodName::line, MethodName::hybrid}) {
        const double whole = mean_of_image(image_of_part(scene, options_of(field, method)));
        for (const int pencils : {16, 32}) {
            const double part = mean_of_image(image_of_part(scene, part_of(field, source, pencils, method)));
            std::printf("%d pencils over all: %.4f\n", pencils, part / whole);
            EXPECT_NEAR(part / whole, 1.0, method == MethodName::line ? 0.1 : 0.05) << pencils;
        }
    }
}

TEST(FieldPart, FollowsTheCameraAndIsReadOnce) {
    Scene scene = both_rooms_lit();
    const auto field = field_of_rooms(scene, 64);
    auto source = std::make_shared<CountingSource>(field);
    Scene left = scene, right = scene;
    look_from(left, true);
    look_from(right, false);
    for (const MethodName method : {MethodName::line, MethodName::hybrid}) {
        const RenderOptions options = part_of(field, source, 24, method);
        source->asked.clear();
        RenderSession session(left, options, device());
        while (session.advance()) {
        }
        EXPECT_EQ(session.stats().field_pencils, 64);
        EXPECT_EQ(session.stats().field_read, 24) << "one room's alone";
        for (const bool to_left : {false, true, false}) {
            const Scene& there = to_left ? left : right;
            session.look(there.sensor);
            EXPECT_LT(image_difference(session.snapshot().front().pixels, image_of_part(there, options)), 0.01) << to_left;
        }
        EXPECT_EQ(session.stats().field_read, 48) << "both rooms'";
    }
}

}  // namespace
}  // namespace pencil::test
