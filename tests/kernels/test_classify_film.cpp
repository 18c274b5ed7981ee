// Grouping of visibility samples into surfels, and the surfels themselves: every sample that shows something has a surfel of its own shape,
// surfels lie on a sample's hit, and flat scenes have one surfel per plane and pixel.
#include <map>

#include "film/rasterize_film.h"
#include "kernels/film_test.h"
#include "pencils/film_filter.h"
#include "reference/tolerances.h"
#include "shared/film.h"

namespace {

using namespace pencil;
using namespace pencil::test;

struct Classified {
    std::vector<Hit> hits;
    std::vector<unsigned char> slots, counts, drawn;
    std::vector<int> first;
    std::vector<glm::vec2> offsets;
    HostSurfels surfels;
};

/// `seed`, `shift`: of the samples that surfels take, 0: the middle ones.
Classified classify(TestScene scene, const TestCamera& view, int samples, uint seed = 0, uint shift = 0,
                    const std::vector<unsigned char>& split = {}) {
    Kernels kernels = make_kernels(false, Weights::dpdf, 0, samples);
    scene.flat.to_film = view.to_film;
    const DeviceScene s(device(), scene.flat);
    const std::vector<glm::vec2> offsets = film_sample_offsets(samples, 6);
    const Buffer<glm::vec2> positions(device(), offsets, "offsets");
    const int rows = view.camera.height;
    const auto pixels = static_cast<std::size_t>(rows) * static_cast<std::size_t>(view.camera.width);
    Buffer<Hit> hits(device(), offsets.size() * pixels, "hits");
    rasterize_film(kernels, s, view.camera, positions, samples, 0, rows, hits);
    Buffer<unsigned char> slots(device(), offsets.size() * pixels, "slots"), counts(device(), pixels, "counts");
    const Buffer<unsigned char> split_pixels(device(), split.empty() ? std::vector<unsigned char>(1) : split, "split pixels");
    kernels.get("classify_film")
        .args(hits, view.camera, positions, samples, 0, rows, s.triangles, s.planes, split_pixels, split.empty() ? 0 : 1, slots, counts)
        .run(pixels, "classify");
    std::vector<int> first;
    int next = 0;
    for (const unsigned char count : counts.read()) {
        first.push_back(next);
        next += count & FILM_COUNT_MASK;
    }
    const Buffer<int> first_surfel(device(), first, "first surfels");
    Surfels surfels(device(), next, "surfels");
    Buffer<unsigned char> drawn(device(), static_cast<std::size_t>(surfels.capacity), "drawn");
    kernels.get("film_surfels")
        .args(hits, view.camera, positions, samples, 0, rows, seed, shift, slots, counts, first_surfel, s.surfaces(), surfels.data,
              surfels.capacity, drawn)
        .run(pixels, "film surfels");
    return {hits.read(), slots.read(), counts.read(), drawn.read(), first, offsets, HostSurfels(surfels)};
}

void check(const TestScene& scene, const TestCamera& view, int samples, uint seed) {
    const Classified c = classify(scene, view, samples, seed, 77 * seed);
    const std::size_t pixels = c.counts.size();
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        SCOPED_TRACE("pixel " + std::to_string(pixel));
        const int count = c.counts[pixel] & FILM_COUNT_MASK;
        bool empty = false;
        std::vector<int> members(static_cast<std::size_t>(count), 0), at_sample(members);
        for (int s = 0; s < samples; ++s) {
            const Hit hit = c.hits[static_cast<std::size_t>(s) * pixels + pixel];
            const int slot = c.slots[pixel * static_cast<std::size_t>(samples) + static_cast<std::size_t>(s)];
            if (hit.triangle < 0) {
                empty = true;
                ASSERT_EQ(slot, NO_SURFEL) << "sample " << s << " shows nothing";
                continue;
            }
            ASSERT_LT(slot, count) << "sample " << s;
            ++members[static_cast<std::size_t>(slot)];
            const int surfel = c.first[pixel] + slot, width = view.camera.width;
            const auto triangle = static_cast<std::size_t>(hit.triangle);
            // Materials stand for shapes; the soup's facets have a plane each, so only samples of one plane may join.
            ASSERT_EQ(c.surfels.plane(surfel), scene.triangles[triangle].plane) << "sample " << s << " joined another plane";
            const glm::vec2 o = c.offsets[static_cast<std::size_t>(s)];
            const int column = static_cast<int>(pixel) % width, row = static_cast<int>(pixel) / width;
            const dvec3 direction = view.direction(column + static_cast<double>(o.x), row + static_cast<double>(o.y));
            const ref::Crossing crossing = ref::cross_triangle(view.origin, direction, scene.triangles[triangle]);
            const dvec3 p = view.origin + crossing.t * direction;
            if (glm::distance(p, c.surfels.position(surfel)) <= 2.0 * tolerance::depth_tie * crossing.slant * crossing.t)
                ++at_sample[static_cast<std::size_t>(slot)];
        }
        ASSERT_EQ((c.counts[pixel] & FILM_HAS_EMPTY) != 0, empty);
        for (int slot = 0; slot < count; ++slot) {
            ASSERT_GT(members[static_cast<std::size_t>(slot)], 0) << "surfel " << slot << " of " << count << " has no sample";
            ASSERT_GT(at_sample[static_cast<std::size_t>(slot)], 0) << "surfel " << slot << " lies on none of its samples";
            const unsigned char drawn = c.drawn[static_cast<std::size_t>(c.first[pixel] + slot)];
            ASSERT_EQ(c.slots[pixel * static_cast<std::size_t>(samples) + drawn], slot) << "surfel " << slot << " lies at another's sample";
            for (int other = 0; other < slot; ++other)
                ASSERT_NE(c.surfels.plane(c.first[pixel] + slot), c.surfels.plane(c.first[pixel] + other)) << "one plane, two surfels";
        }
    }
}

TEST(ClassifyFilm, BoxRoomAndSoup) {
    const TestCamera inside = make_camera({0.4, 0.3, -0.6}, {-0.5, -0.3, 1}, {0, 1, 0}, 1.0, 33, 21);
    for (const int samples : {1, 4, 16}) {
        SCOPED_TRACE(std::to_string(samples) + " samples");
        for (const uint seed : {0U, 5U}) {
            check(box_scene(121), inside, samples, seed);
            check(soup_scene(122, 30), make_camera({0.1, 0.2, -2.5}, {0, 0, 1}, {0, 1, 0}, 0.5, 37, 23), samples, seed);
        }
    }
}

/// Shares at equal steps take every sample of a pixel equally often.
TEST(ClassifyFilm, SurfelsOfManyImagesLieAtAllSamples) {
    constexpr int samples = 16, images = 64;
    const TestScene scene = box_scene(124);
    const TestCamera inside = make_camera({0.4, 0.3, -0.6}, {-0.5, -0.3, 1}, {0, 1, 0}, 1.0, 9, 7);
    std::vector<std::map<std::vector<double>, int>> taken;  // of each pixel: how often a surfel lies at a place
    for (uint image = 0; image < images; ++image) {
        const Classified c = classify(scene, inside, samples, 3, image << 26);
        taken.resize(c.counts.size());
        for (std::size_t pixel = 0; pixel < c.counts.size(); ++pixel) {
            const dvec3 x = c.surfels.position(c.first[pixel]);
            if (c.counts[pixel] == 1) ++taken[pixel][{x.x, x.y, x.z}];
        }
    }
    int looked = 0;
    for (const auto& places : taken) {
        if (places.empty()) continue;
        ++looked;
        EXPECT_EQ(places.size(), samples);
        for (const auto& [place, count] : places) EXPECT_EQ(count, images / samples);
    }
    EXPECT_GT(looked, 30);
}

/// Every sample of a split pixel that shows something has a surfel, and lies at it; the other pixels are as they were.
TEST(ClassifyFilm, SplitPixelsHaveASurfelPerSample) {
    constexpr int samples = 16;
    const TestScene scene = soup_scene(125, 30);
    const TestCamera view = make_camera({0.1, 0.2, -2.5}, {0, 0, 1}, {0, 1, 0}, 0.5, 17, 13);
    std::vector<unsigned char> split(17 * 13);
    for (std::size_t pixel = 0; pixel < split.size(); pixel += 3) split[pixel] = 1;
    const Classified joined = classify(scene, view, samples, 3), c = classify(scene, view, samples, 3, 0, split);
    int seen = 0;
    for (std::size_t pixel = 0; pixel < split.size(); ++pixel) {
        if (split[pixel] == 0) {
            EXPECT_EQ(c.counts[pixel], joined.counts[pixel]);
            continue;
        }
        int surfels = 0;
        for (std::size_t s = 0; s < samples; ++s) {
            const unsigned char slot = c.slots[pixel * samples + s];
            EXPECT_EQ(slot == NO_SURFEL, joined.slots[pixel * samples + s] == NO_SURFEL);
            if (slot == NO_SURFEL) continue;
            EXPECT_EQ(slot, surfels) << "in the order of the samples";
            EXPECT_EQ(c.drawn[static_cast<std::size_t>(c.first[pixel] + slot)], s);
            ++surfels;
        }
        EXPECT_EQ(c.counts[pixel] & FILM_COUNT_MASK, surfels);
        seen += surfels;
    }
    EXPECT_GT(seen, 200);
}

TEST(ClassifyFilm, InteriorPixelsHaveOneSurfel) {
    const TestCamera inside = make_camera({0.4, 0.3, -0.6}, {-0.5, -0.3, 1}, {0, 1, 0}, 1.0, 64, 64);
    const Classified c = classify(box_scene(123), inside, 16);
    int one = 0;
    for (const unsigned char count : c.counts) one += count == 1 ? 1 : 0;
    EXPECT_GT(one, 64 * 64 * 8 / 10);
    EXPECT_LT(one, 64 * 64) << "edges of the box cross some pixels";
}

}  // namespace
