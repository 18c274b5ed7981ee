// The direction that surfels were seen from, where a feature asks for it: unit vectors to the viewer behind the other fields, which do not
// change; nothing is stored without the feature.
#include "film/film.h"
#include "kernels/film_test.h"
#include "pencils/film_filter.h"
#include "reference/tolerances.h"

namespace {

using namespace pencil;
using namespace pencil::test;

Kernels kernels_with(bool outgoing) {
    Features features;
    features.film_samples = 4;
    features.lobes = outgoing;
    return Kernels(device(), features);
}

/// Bits, so that integer fields and signs of zeros count.
std::vector<std::uint32_t> field_bits(const HostSurfels& surfels, int field) {
    std::vector<std::uint32_t> out(surfels.capacity);
    std::memcpy(out.data(), surfels.data.data() + static_cast<std::size_t>(field) * surfels.capacity, surfels.capacity * sizeof(float));
    return out;
}

/// Compares surfels written without and with the feature; `viewer(i)`: where surfel i was seen from.
template <typename Viewer>
void check(const Surfels& off, const Surfels& on, const Viewer& viewer) {
    const HostSurfels without(off), with(on);
    ASSERT_EQ(without.data.size(), without.capacity * SURFEL_FIELDS) << "nothing is allocated for it";
    ASSERT_EQ(with.data.size(), with.capacity * SURFEL_FIELDS_OUTGOING);
    ASSERT_EQ(with.count, without.count);
    for (int f = 0; f < SURFEL_FIELDS; ++f) ASSERT_EQ(field_bits(with, f), field_bits(without, f)) << "field " << f;
    int seen = 0;
    for (int i = 0; i < with.count; ++i) {
        const dvec3 outgoing = with.vector(SURFEL_OX, i);
        if (with.plane(i) < 0) {
            ASSERT_NEAR(glm::length(outgoing), 1.0, tolerance::few_operations) << "against the ray, for what is infinitely far away";
            continue;
        }
        ++seen;
        ASSERT_EQ(with.vector(SURFEL_TR, i), dvec3(1.0)) << "no chain";
        ASSERT_EQ(with.at(SURFEL_SHARE, i), -1.0F);
        const dvec3 to_viewer = viewer(i) - with.position(i);
        // The stored position is rounded: near the viewer that turns the direction to it.
        const double bound = tolerance::few_operations * (1.0 + 1.0 / glm::length(to_viewer));
        ASSERT_NEAR(glm::length(outgoing), 1.0, tolerance::few_operations);
        ASSERT_LE(glm::distance(outgoing, glm::normalize(to_viewer)), bound) << "surfel " << i;
        ASSERT_GE(glm::dot(outgoing, with.face_normal(i)), -tolerance::few_operations) << "the side that was seen";
    }
    EXPECT_GT(seen, 0);
}

TEST(Outgoing, OfTexels) {
    Random random(51);
    const TestScene scene = soup_scene(52, 60);
    const DeviceScene on_device(device(), scene.flat);
    const std::vector<float4> centres = random_centres(random, 3);
    Kernels off_kernels = kernels_with(false), on_kernels = kernels_with(true);
    for (const int n : {8, 24}) {
        const GeometryMaps maps = rasterized(off_kernels, on_device, centres, n);
        Surfels off(off_kernels, maps.count * n * n, "off"), on(on_kernels, maps.count * n * n, "on");
        for (Surfels* used : {&off, &on})  // buffers are used again: surfels that see nothing must say so
            used->data = Buffer<float>(device(), std::vector<float>(static_cast<std::size_t>(used->capacity * used->fields), 7.0F), "used");
        gather_surfels(off_kernels, on_device, maps, 0, maps.count, off);
        gather_surfels(on_kernels, on_device, maps, 0, maps.count, on);
        check(off, on, [&](int i) { return xyz(centres[static_cast<std::size_t>(i / (n * n))]); });
    }
}

TEST(Outgoing, OfTheFilm) {
    const TestCamera view = make_camera({0.4, 0.3, -0.6}, {-0.5, -0.3, 1}, {0, 1, 0}, 1.0, 33, 21);
    TestScene scene = room_scene(53, 12);
    scene.flat.to_film = view.to_film;
    const DeviceScene on_device(device(), scene.flat);
    Kernels off_kernels = kernels_with(false), on_kernels = kernels_with(true);
    const FilmCamera camera{view.camera, glm::vec3(view.origin)};
    const Film off(off_kernels, on_device, camera, ReconstructionFilter{}, Turn{}),
        on(on_kernels, on_device, camera, ReconstructionFilter{}, Turn{});
    check(off.surfels(), on.surfels(), [&](int) { return view.origin; });
}

TEST(Outgoing, ReserveKeepsAllFields) {
    Surfels surfels(kernels_with(true), 100, "few");
    std::vector<float> values;
    for (std::size_t k = 0; k < surfels.data.read().size(); ++k) values.push_back(static_cast<float>(k));
    surfels.data = Buffer<float>(device(), values, "numbered");
    const HostSurfels before(surfels);
    surfels.reserve(device(), 1000, "many");
    const HostSurfels after(surfels);
    ASSERT_EQ(after.count, 100);
    ASSERT_EQ(after.data.size(), after.capacity * SURFEL_FIELDS_OUTGOING);
    for (int f = 0; f < SURFEL_FIELDS_OUTGOING; ++f)
        for (int i = 0; i < after.count; ++i) ASSERT_EQ(after.at(f, i), before.at(f, i)) << "field " << f << " of surfel " << i;
}

TEST(Outgoing, OffWhileAllMaterialsAreDiffuse) {
    TestScene scene = box_scene(54);
    EXPECT_FALSE(scene_features(scene.flat, 4, true).outgoing());
    scene.flat.materials.back().model = MATERIAL_DIFFUSE + 1;
    EXPECT_TRUE(scene_features(scene.flat, 4, true).outgoing());
    EXPECT_FALSE(scene_features(scene.flat, 4, false).outgoing()) << "a method that takes lobes for even needs no direction";
}

}  // namespace
