// Radiance maps as an image against the same as a buffer: single texels bit by bit, filtered ones to the precision of the device's
// interpolation weights, and so what project_pencils makes of them.
#include <cmath>

#include "cl/texel_image.h"
#include "device/radiance_atlas.h"
#include "kernels/kernel_test.h"
#include "line/project_pencils.h"
#include "reference/tolerances.h"
#include "util/error.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr const char* atlas_kernels = PENCIL_SOURCE_DIR "/tests/kernels/test_atlas.cl";

bool has_images() { return image_limits(*device()).layers > 0; }

struct LookedUp {
    std::vector<float4> filtered, texels;
};

struct Directions {
    Directions(Random& random, int count) {
        for (int i = 0; i < count; ++i) {
            const dvec3 d = random.direction();
            x.push_back(static_cast<float>(d.x));
            y.push_back(static_cast<float>(d.y));
            z.push_back(static_cast<float>(d.z));
        }
    }
    std::vector<float> x, y, z;
};

template <typename Radiance>
LookedUp look_up(const Directions& at, const Radiance& radiance, int tiles, const MapShape& shape, bool image) {
    ProgramCache programs(device());
    const Buffer<float> x(device(), at.x, "x"), y(device(), at.y, "y"), z(device(), at.z, "z");
    const int count = static_cast<int>(at.x.size());
    Buffer<float4> filtered(device(), at.x.size(), "filtered"), texels(device(), at.x.size(), "texels");
    programs
        .kernel("look_up_atlas", atlas_kernels,
                {{"PENCIL_ATLAS_IMAGE", image ? "1" : "0"}, {"PENCIL_MAP_KIND", std::to_string(shape.kind)}})
        .args(x, y, z, count, radiance, tiles, shape.n, filtered, texels)
        .run(static_cast<std::size_t>(count / device()->packet_width()), "look-ups");
    return {filtered.read(), texels.read()};
}

std::vector<float4> random_texels(Random& random, std::size_t count) {
    std::vector<float4> texels;
    texels.reserve(count);
    for (std::size_t i = 0; i < count; ++i) texels.push_back(to_float4(random.in_box(0.0, 3.0), random.uniform(0.05, 1.0)));
    return texels;
}

TEST(Atlas, ImageHoldsWhatTheBufferHolds) {
    if (!has_images()) GTEST_SKIP() << "no images on " << device()->info().name;
    Random random(301);
    for (const int kind : {PENCIL_MAP_OCTAHEDRAL, PENCIL_MAP_CUBE, PENCIL_MAP_PARABOLOID, PENCIL_MAP_PYRAMID})
        for (const auto& [tiles, width] : {std::pair(1, 8), std::pair(7, 24), std::pair(33, 64)}) {
            const MapShape shape(kind, width);
            const Directions at(random, 1600);
            const std::size_t stride = PENCIL_TILE_STRIDE(static_cast<std::size_t>(shape.n)),
                              stored = static_cast<std::size_t>(shape.stored());
            const Buffer<float4> buffer(device(), random_texels(random, stored * static_cast<std::size_t>(tiles)), "texels");
            TexelImage image(device(), stride, stored / stride, static_cast<std::size_t>(tiles), "texels");
            image.copy_from(buffer);
            const LookedUp by_buffer = look_up(at, buffer, tiles, shape, false), by_image = look_up(at, image, tiles, shape, true);
            double worst = 0;
            for (std::size_t i = 0; i < at.x.size(); ++i) {
                ASSERT_EQ(by_image.texels[i], by_buffer.texels[i]) << "kind " << kind << ", direction " << i;
                for (int c = 0; c < 4; ++c)
                    worst = std::max(worst, static_cast<double>(std::abs(by_image.filtered[i][c] - by_buffer.filtered[i][c])));
            }
            EXPECT_LE(worst, 3.0 * tolerance::image_weights)
                << "texels differ by 3 at most; kind " << kind << ", " << tiles << " of " << width;
            RecordProperty("worst", std::to_string(worst));
        }
}

/// What surfels of a room receive from random maps. Lines balanced with rays: scenes/test_atlas.cpp.
std::vector<float> projected(bool image, Weights weights) {
    Random random(302);
    Features features;
    features.weights = kernel_weights(weights);
    features.cell_grid = weights_are_cells(features.weights) ? largest_cell_grid(40) : 0;
    features.atlas_image = image;
    Kernels kernels(device(), features);
    const TestScene scene = room_scene(303, 20);
    const DeviceScene on_device(device(), scene.flat);
    PencilSet set(device(), std::make_shared<GeometryMaps>(rasterized(kernels, on_device, random_centres(random, 40), 16)));
    set.radiance.write(random_texels(random, set.radiance.size()));
    const Surfels surfels = gathered(kernels, on_device, random_centres(random, 3), 16, 700);
    Buffer<float> outgoing = surfel_rgb(device(), surfels.capacity, "outgoing");
    Buffer<int> visible(device(), static_cast<std::size_t>(surfels.capacity), "visible");
    WeightTables tables(kernels);
    project_pencils(kernels, on_device, surfels, set, tables, outgoing, visible, "test");
    return outgoing.read();
}

TEST(Atlas, ProjectionIsTheSameByImageAndBuffer) {
    if (!has_images()) GTEST_SKIP() << "no images on " << device()->info().name;
    for (const Weights weights : {Weights::dpdf, Weights::voronoi, Weights::analytic, Weights::thesis}) {
        const std::vector<float> image = projected(true, weights), buffer = projected(false, weights);
        double scale = 0, worst = 0;
        for (const float value : buffer) scale = std::max(scale, std::abs(static_cast<double>(value)));
        EXPECT_GT(scale, 0);
        for (std::size_t i = 0; i < buffer.size(); ++i) worst = std::max(worst, std::abs(static_cast<double>(image[i]) - buffer[i]));
        // Radiance and density weight, of which texels next to each other differ by as much as there is, both by image_weights.
        EXPECT_LE(worst, 20 * tolerance::image_weights * scale) << "weights " << static_cast<int>(weights);
    }
}

TEST(Atlas, IsAnImageWhereThatIsAskedForOrMeasured) {
    const std::shared_ptr<Device> own = Device::open("");
    const MapShape shape(PENCIL_MAP_OCTAHEDRAL, 64);
    EXPECT_FALSE(atlas_is_image(Atlas::automatic, *own, shape, 128)) << "no device takes images unmeasured";
    EXPECT_FALSE(atlas_is_image(Atlas::buffer, *own, shape, 128));
    const int too_many = static_cast<int>(image_limits(*own).layers) + 1;
    try {
        atlas_is_image(Atlas::image, *own, shape, too_many);
        ADD_FAILURE() << "too many layers";
    } catch (const UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("--atlas buffer"), std::string::npos) << error.what();
    }
    DeviceProfile measured = own->profile();
    measured.atlas_image = true;
    own->set_profile(measured);
    EXPECT_EQ(atlas_is_image(Atlas::automatic, *own, shape, 128), has_images());
    EXPECT_FALSE(atlas_is_image(Atlas::automatic, *own, shape, too_many));
    EXPECT_FALSE(atlas_is_image(Atlas::buffer, *own, shape, 128));
}

}  // namespace
