// Visibility samples of the film, rasterised and traced, against a brute-force ray cast of every sample: the same truth and the same ties as the
// octahedral maps.
#include "film/rasterize_film.h"
#include "film/trace_film.h"
#include "kernels/film_test.h"
#include "pencils/build_bvh.h"
#include "pencils/film_filter.h"
#include "reference/tolerances.h"

namespace {

using namespace pencil;
using namespace pencil::test;

using Look = void(Kernels&, const DeviceScene&, const Camera&, const Buffer<glm::vec2>&, int, int, int, Buffer<Hit>&, const std::string&);

std::vector<Hit> see(Look look, TestScene scene, const TestCamera& view, const std::vector<glm::vec2>& offsets, int first_row, int rows) {
    Kernels kernels = make_kernels();
    scene.flat.to_film = view.to_film;
    const DeviceScene on_device(device(), scene.flat, build_bvh(scene.flat.triangles));
    const Buffer<glm::vec2> positions(device(), offsets, "offsets");
    Buffer<Hit> hits(device(), offsets.size() * static_cast<std::size_t>(rows * view.camera.width), "hits");
    look(kernels, on_device, view.camera, positions, static_cast<int>(offsets.size()), first_row, rows, hits, "film hits");
    return hits.read();
}

void check(Look look, const TestScene& scene, const TestCamera& view, int samples, int first_row, int rows, int least_seen) {
    const std::vector<glm::vec2> offsets = film_sample_offsets(samples, 5);
    const std::vector<Hit> hits = see(look, scene, view, offsets, first_row, rows);
    int ties = 0, seen = 0;
    for (std::size_t k = 0; k < hits.size(); ++k) {
        const int width = view.camera.width, x = static_cast<int>(k) % width, row = static_cast<int>(k) / width % rows;
        const std::size_t sample = k / static_cast<std::size_t>(width * rows);
        const dvec3 direction =
            view.direction(x + static_cast<double>(offsets[sample].x), first_row + row + static_cast<double>(offsets[sample].y));
        SCOPED_TRACE("sample " + std::to_string(sample) + " pixel " + std::to_string(x) + " " + std::to_string(first_row + row));
        const double near = view.camera.near_clip, far = view.camera.far_clip;
        const dvec3 start = view.origin + near * direction;  // what lies before the near plane is not there
        ref::RayHit truth = ref::nearest_triangle(scene.triangles, start, direction);
        truth.t += near;
        const Hit hit = hits[k];
        const bool beyond = truth.triangle >= 0 && truth.t > far;  // it hides what is behind it, but is not seen
        if (beyond) truth.triangle = -1;
        if (hit.triangle != truth.triangle) {
            ++ties;
            const auto at_clip = [&](double t) { return std::abs(t / near - 1.0) < 1e-5 || std::abs(t / far - 1.0) < 1e-5; };
            ASSERT_TRUE(at_clip(truth.t) || at_clip(1.0 / hit.disparity) ||
                        (!beyond && ref::is_plausible(scene.triangles, start, direction, hit.triangle)))
                << "triangle " << hit.triangle << " instead of " << truth.triangle << ", margin " << truth.margin;
        }
        if (hit.triangle < 0) continue;
        ++seen;
        const ref::Crossing c = ref::cross_triangle(view.origin, direction, scene.triangles[static_cast<std::size_t>(hit.triangle)]);
        ASSERT_LE(std::abs(hit.disparity * c.t - 1.0), tolerance::depth_tie * c.slant)
            << "disparity " << hit.disparity << " instead of " << 1.0 / c.t;
    }
    EXPECT_LE(ties, 2 + 5e-4 * static_cast<double>(hits.size()));
    EXPECT_GE(seen, least_seen);
}

void check(const TestScene& scene, const TestCamera& view, int samples, int first_row, int rows, int least_seen = 1) {
    for (Look* look : {rasterize_film, trace_film}) check(*look, scene, view, samples, first_row, rows, least_seen);
}

TEST(RasterizeFilm, SoupsRoomsAndSizes) {
    check(soup_scene(111, 40), make_camera({0.1, 0.2, -2.5}, {0, 0, 1}, {0, 1, 0}, 0.5, 1, 1), 64, 0, 1);
    check(soup_scene(111, 40), make_camera({0.1, 0.2, -2.5}, {0, 0, 1}, {0, 1, 0}, 0.5, 37, 23), 5, 0, 23);
    check(soup_scene(112, 200), make_camera({0.1, 0.05, 0.02}, {0.3, -0.2, 1}, {0, 1, 0}, 1.2, 64, 48), 2, 0, 48);
    check(room_scene(113, 40), make_camera({0.4, 0.3, -0.6}, {-0.5, -0.3, 1}, {0, 1, 0.1}, 2.0, 50, 70), 4, 0, 70);
    check(room_scene(114, 20), make_camera({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 1.0, 32, 32), 1, 0, 32);  // on the symmetry axes
}

TEST(RasterizeFilm, StripOfRows) {
    check(room_scene(115, 30), make_camera({0.4, 0.3, -0.6}, {-0.5, -0.3, 1}, {0, 1, 0}, 1.0, 40, 60), 3, 17, 21);
}

TEST(RasterizeFilm, ClipDistances) {
    TestCamera view = make_camera({0, 0, -0.7}, {0, 0, 1}, {0, 1, 0}, 1.0, 40, 40);
    view.camera.near_clip = 0.5F;
    view.camera.far_clip = 1.2F;
    check(room_scene(116, 40), view, 2, 0, 40);
    // From outside: the near plane cuts the room open.
    view = make_camera({0, 0, -2.5}, {0, 0, 1}, {0, 1, 0}, 0.4, 40, 40);
    view.camera.near_clip = 1.83F;
    check(room_scene(116, 40), view, 2, 0, 40, 1000);
}

TEST(RasterizeFilm, CameraOnATriangle) {
    const TestScene scene = soup_scene(117, 30);
    for (std::size_t i = 0; i < 5; ++i) {
        const ref::Triangle& t = scene.triangles[i];
        check(scene, make_camera(t.v0, {0.1, 0.2, 1}, {0, 1, 0}, 1.0, 24, 24), 2, 0, 24, 0);
        check(scene, make_camera((t.v0 + t.v1 + t.v2) / 3.0, {0.1, 0.2, -1}, {0, 1, 0}, 1.0, 24, 24), 2, 0, 24, 0);
    }
}

}  // namespace
