#include "reference/camera_rays.h"

#include <algorithm>
#include <cmath>

namespace pencil {
namespace {

/// The part of the film that an image shows, when the film's pixels are those of the image.
struct Window {
    double film_width, film_height, x, y;
    Window(const PerspectiveSensor& s, int width, int height) : film_width(width), film_height(height), x(0), y(0) {
        if (s.crop_width <= 0 || s.crop_height <= 0) return;
        const double columns = static_cast<double>(width) / s.crop_width, rows = static_cast<double>(height) / s.crop_height;
        film_width = s.width * columns;
        film_height = s.height * rows;
        x = s.crop_x * columns;
        y = s.crop_y * rows;
    }
};

/// Where the filter of pixel i lies within the film; of a window that was scaled, to the nearest border of a pixel.
FilterSampler::Range range_of(const FilterSampler& filter, int i, double first, double size) {
    const double before = std::round(first) + i;
    return filter.range(-before - 0.5, std::max(std::round(size) - before, 1.0) - 0.5);
}

/// Uniform on the unit disk, by Shirley and Chiu's concentric map.
glm::dvec2 disk(const glm::dvec2& u) {
    const glm::dvec2 p = 2.0 * u - 1.0;
    if (p == glm::dvec2(0.0)) return p;
    constexpr double quarter = 0.78539816339744830962;
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const double r = wide ? p.x : p.y, phi = wide ? quarter * (p.y / p.x) : quarter * (2 - p.x / p.y);
    return r * glm::dvec2(std::cos(phi), std::sin(phi));
}

}  // namespace

CameraRays::CameraRays(const PerspectiveSensor& sensor, const RayScene& scene, int width, int height)
    : filter_(sensor.filter),
      near_(sensor.near_clip / scene.scale()),
      far_(sensor.far_clip / scene.scale()),
      parallel_(sensor.orthographic) {
    const glm::dvec3 axes[3] = {glm::dvec3(sensor.to_world[0]), glm::dvec3(sensor.to_world[1]), glm::dvec3(sensor.to_world[2])};
    const glm::dvec3 left = glm::normalize(axes[0]), up = glm::normalize(axes[1]);
    forward_ = glm::normalize(axes[2]);
    const Window window(sensor, width, height);
    eye_ = scene.to_scene(glm::dvec3(sensor.to_world[3]));
    if (parallel_) {
        // The frame may be scaled: that is how wide the film is.
        step_x_ = axes[0] * (-2 / (window.film_width * scene.scale()));
        step_y_ = axes[1] * (-2 / (window.film_width * scene.scale()));
    } else {
        const double pixel = 2 * std::tan(glm::radians(sensor.fov_x) / 2) / window.film_width;  // at unit depth
        step_x_ = -pixel * left;
        step_y_ = -pixel * up;
    }
    corner_ = (parallel_ ? glm::dvec3(0.0) : forward_) -
              step_x_ * (window.film_width * (0.5 + sensor.principal_point_offset.x) - window.x) -
              step_y_ * (window.film_height * (0.5 + sensor.principal_point_offset.y) - window.y);
    if (sensor.aperture_radius > 0 && !parallel_) {
        lens_x_ = left * (sensor.aperture_radius / scene.scale());
        lens_y_ = up * (sensor.aperture_radius / scene.scale());
        inverse_focus_ = scene.scale() / sensor.focus_distance;
    }
    for (int x = 0; x < width; ++x) columns_.push_back(range_of(filter_, x, window.x, window.film_width));
    for (int y = 0; y < height; ++y) rows_.push_back(range_of(filter_, y, window.y, window.film_height));
    // A margin of some rounding errors, so that walls of the box are met.
    low_ = scene.low() - 1e-5;
    high_ = scene.high() + 1e-5;
}

CameraRays::Sample CameraRays::sample(int x, int y, Sampler& sampler) const {
    const glm::dvec2 u = sampler.next_2d();
    const FilterSampler::Sample px = filter_.sample(columns_[static_cast<std::size_t>(x)], u.x),
                                py = filter_.sample(rows_[static_cast<std::size_t>(y)], u.y);
    const glm::dvec3 on_film = corner_ + (x + 0.5 + px.offset) * step_x_ + (y + 0.5 + py.offset) * step_y_;
    glm::dvec3 origin = parallel_ ? eye_ + on_film : eye_, direction = parallel_ ? forward_ : on_film;
    if (inverse_focus_ > 0) {
        const glm::dvec2 lens = disk(sampler.next_2d());
        const glm::dvec3 moved = lens.x * lens_x_ + lens.y * lens_y_;
        origin += moved;
        direction -= inverse_focus_ * moved;  // depth stays 1, and all rays of a place meet in the plane of focus
    }
    Sample sample;
    sample.weight = px.weight * py.weight;
    // From where the ray enters the scene's box, in double precision: a camera far away loses no digits.
    double begin = near_, end = far_;
    for (int k = 0; k < 3; ++k) {
        const double inverse = 1 / direction[k], a = (low_[k] - origin[k]) * inverse, b = (high_[k] - origin[k]) * inverse;
        begin = std::max(begin, std::min(a, b));  // 0 * infinity compares false and leaves the interval as it is
        end = std::min(end, std::max(a, b));
    }
    sample.meets = begin < end;
    sample.ray = {glm::vec3(origin), glm::vec3(direction)};
    if (sample.meets) sample.ray = {glm::vec3(origin + begin * direction), glm::vec3(direction), static_cast<float>(end - begin)};
    return sample;
}

}  // namespace pencil
