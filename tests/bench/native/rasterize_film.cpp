#include <cmath>

#include "bench/native/native.h"
#include "bench/native/parallel.h"
#include "bench/native/raster.h"

namespace pencil::native {
namespace {

constexpr float slack = 1e-2F, least_ahead = 1e-6F;
constexpr int sample_band = 8;  // rows drawn at once

struct Box {
    float x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;
    void add(float x, float y) { *this = grown(x, y); }
    Box grown(float x, float y) const {
        Box b;
        b.x0 = std::min(x0, x), b.y0 = std::min(y0, y), b.x1 = std::max(x1, x), b.y1 = std::max(y1, y);
        return b;
    }
};

/// A triangle as the film sees it: the same for all samples but for their offset.
struct Projected {
    int index;
    float4v p0, p1, p2;
    Box box;
    float ahead;
};

Box film_box(const float4v* p, const float4* to_film) {
    const float4v rx = load4(to_film[0]), ry = load4(to_film[1]), rz = load4(to_film[2]);
    Box box;
    for (int i = 0; i < 3; ++i) {
        const float4v a = p[i], b = p[(i + 1) % 3];
        const float da = dot3(rz, a), db = dot3(rz, b);
        if (da >= least_ahead) box.add(dot3(rx, a) / da, dot3(ry, a) / da);
        if ((da >= least_ahead) != (db >= least_ahead)) {
            const float4v c = a + (b - a) * ((least_ahead - da) / (db - da));
            box.add(dot3(rx, c) / least_ahead, dot3(ry, c) / least_ahead);
        }
    }
    return box;
}

std::vector<Projected> project_scene(const SceneView& scene, float4v eye, const float4* to_film) {
    std::vector<Projected> out;
    for (int i = 0; i < scene.triangle_count; ++i) {
        const Triangle& t = scene.triangles[i];
        const float ahead = plane_ahead(scene.planes[t.plane], eye);
        if (std::abs(ahead) < plane_tolerance) continue;
        const float4v p[3] = {load_point(t.v0) - eye, load_point(t.v1) - eye, load_point(t.v2) - eye};
        out.push_back({i, p[0], p[1], p[2], film_box(p, to_film), ahead});
    }
    return out;
}

void draw_band(const SceneView& scene, const Camera& camera, const std::vector<Projected>& triangles, const glm::vec2& offset,
               int first_row, int top, int bottom, RasterTarget& target) {
    const float4v step_x = load_point(camera.step_x), step_y = load_point(camera.step_y);
    const RasterFrame frame{load_point(camera.corner) + offset.x * step_x + (offset.y + static_cast<float>(first_row)) * step_y, step_x,
                            step_y};
    const float shift_x = 0.5F - offset.x, shift_y = 0.5F - offset.y - static_cast<float>(first_row);
    for (const Projected& t : triangles) {
        const Range ys = raster_range(t.box.y0 + shift_y, t.box.y1 + shift_y, slack, bottom - 1);
        if (ys.last < top || ys.first > ys.last) continue;
        const Range xs = raster_range(t.box.x0 + shift_x, t.box.x1 + shift_x, slack, camera.width - 1);
        if (xs.first > xs.last) continue;
        const RasterTriangle r = raster_setup(t.p0, t.p1, t.p2, scene.planes[scene.triangles[t.index].plane], t.ahead, frame);
        for (int y = std::max(ys.first, top); y <= ys.last; ++y)
            raster_row(r, t.index, 0.0F, 1.0F, static_cast<float>(y), xs.first, xs.last, y - top, target);
    }
}

}  // namespace

void rasterize_film(const SceneView& scene, const Camera& camera, const float4* to_film, const std::vector<glm::vec2>& offsets,
                    int first_row, int rows, Hit* hits) {
    const std::vector<Projected> triangles = project_scene(scene, load_point(camera.origin), to_film);
    const int bands = (rows + sample_band - 1) / sample_band;
    const float nearest = camera.near_clip > 0.0F ? 1.0F / camera.near_clip : INFINITY, farthest = 1.0F / camera.far_clip;
    parallel_blocks(bands * static_cast<int>(offsets.size()), 1, [&](int item, int) {
        thread_local RasterTarget target(camera.width, sample_band);
        if (target.stride != camera.width + lane_count) target = RasterTarget(camera.width, sample_band);
        target.clear();
        const int sample = item / bands, top = item % bands * sample_band, bottom = std::min(top + sample_band, rows);
        draw_band(scene, camera, triangles, offsets[static_cast<std::size_t>(sample)], first_row, top, bottom, target);
        for (int y = top; y < bottom; ++y) {
            Hit* row = hits + (static_cast<std::size_t>(sample) * static_cast<std::size_t>(rows) + static_cast<std::size_t>(y)) *
                                  static_cast<std::size_t>(camera.width);
            target.write_row(y - top, camera.width, row);
            for (int x = 0; x < camera.width; ++x)
                if (row[x].disparity > nearest || row[x].disparity < farthest) row[x].triangle = -1;
        }
    });
}

}  // namespace pencil::native
