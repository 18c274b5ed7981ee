#include "reference/film_sums.h"

#include <algorithm>
#include <functional>
#include <glm/gtx/component_wise.hpp>
#include <limits>
#include <string>

#include "image/relative_error.h"

namespace pencil {
namespace {

int orders_of(int max_depth) { return max_depth < 0 ? most_orders : std::clamp(max_depth, 1, most_orders); }

std::string order_name(int order, int max_depth) {
    if (order == 0) return emission_layer;
    // The last slot holds all further orders, or just one if the depth ends there.
    if (order == most_orders - 1 && max_depth != most_orders) return tail_layer(order);
    return bounce_layer(order);
}

/// An image with `value(pixel)` in each pixel that has a sample, 0 elsewhere.
Layer make_layer(const std::string& name, const std::vector<int>& samples, const std::function<glm::dvec3(std::size_t)>& value) {
    Layer layer{name, 3, std::vector<float>(3 * samples.size(), 0.0F)};
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples[i] == 0) continue;
        const glm::dvec3 v = value(i);
        for (int c = 0; c < 3; ++c) layer.pixels[3 * i + static_cast<std::size_t>(c)] = static_cast<float>(v[c]);
    }
    return layer;
}

}  // namespace

FilmSums::FilmSums(int width, int height, const ReferenceOptions& options)
    : first_order_(options.field ? 1 : 0), max_depth_(options.max_depth), variance_(options.variance) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    total_.resize(pixels, glm::dvec3(0));
    if (variance_ || !options.field) {
        ended_.resize(pixels, glm::dvec3(0));
        squares_.resize(pixels, glm::dvec3(0));
    }
    if (options.bounces) orders_.resize(static_cast<std::size_t>(orders_of(max_depth_)), std::vector<glm::dvec3>(pixels, glm::dvec3(0)));
    if (options.surfaces) surfaces_.resize(pixels);
}

void FilmSums::add(std::size_t pixel, const PathSums& paths, const SurfaceSums& surfaces) {
    for (int k = first_order_; k < paths.orders; ++k) {
        const auto order = static_cast<std::size_t>(k);
        total_[pixel] += glm::dvec3(paths.radiance[order]);
        if (!orders_.empty()) orders_[order][pixel] += glm::dvec3(paths.radiance[order]);
    }
    if (surfaces_.empty()) return;
    SurfaceSums& sums = surfaces_[pixel];
    sums.albedo += surfaces.albedo;
    sums.normal += surfaces.normal;
    sums.position += surfaces.position;
    sums.weight += surfaces.weight;
}

void FilmSums::end_set(std::size_t pixel, int samples) {
    if (ended_.empty()) return;
    const glm::dvec3 set = total_[pixel] - ended_[pixel];
    squares_[pixel] += set * set / static_cast<double>(samples);
    ended_[pixel] = total_[pixel];
}

std::vector<Layer> FilmSums::layers(const std::vector<int>& samples, const std::vector<int>& sets, const RayScene& scene,
                                    const glm::dvec3& eye) const {
    std::vector<Layer> layers;
    layers.push_back(make_layer("", samples, [&](std::size_t i) { return total_[i] / static_cast<double>(samples[i]); }));
    add_light_layers(samples, layers);
    if (!surfaces_.empty()) add_surface_layers(samples, scene, eye, layers);
    if (variance_) layers.push_back(make_layer(variance_layer, samples, [&](std::size_t i) { return variance(i, samples[i], sets[i]); }));
    return layers;
}

/// Orders that no path has reached are left out, as `render` leaves out bounces that it did not compute.
void FilmSums::add_light_layers(const std::vector<int>& samples, std::vector<Layer>& layers) const {
    for (std::size_t order = 0; order < orders_.size(); ++order) {
        const std::vector<glm::dvec3>& sums = orders_[order];
        const bool empty = std::all_of(sums.begin(), sums.end(), [](const glm::dvec3& v) { return v == glm::dvec3(0); });
        if (order > 1 && empty) continue;
        layers.push_back(make_layer(order_name(static_cast<int>(order), max_depth_), samples,
                                    [&](std::size_t i) { return sums[i] / static_cast<double>(samples[i]); }));
    }
}

/// Albedo and normal are filtered like light; positions are those of the part of a pixel that shows a surface, and depth is their distance.
void FilmSums::add_surface_layers(const std::vector<int>& samples, const RayScene& scene, const glm::dvec3& eye,
                                  std::vector<Layer>& layers) const {
    const auto mean = [&](glm::vec3 SurfaceSums::*field, std::size_t i) {
        return glm::dvec3(surfaces_[i].*field) / static_cast<double>(samples[i]);
    };
    layers.push_back(make_layer(albedo_layer, samples, [&](std::size_t i) { return mean(&SurfaceSums::albedo, i); }));
    Layer position = make_layer(position_layer, samples, [&](std::size_t i) {
        const SurfaceSums& s = surfaces_[i];
        return s.weight > 0 ? scene.to_world(glm::dvec3(s.position) / static_cast<double>(s.weight)) : glm::dvec3(0);
    });
    Layer depth{depth_layer, 1, std::vector<float>(samples.size(), 0.0F)};
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const glm::dvec3 p(position.pixels[3 * i], position.pixels[3 * i + 1], position.pixels[3 * i + 2]);
        if (surfaces_[i].weight > 0) depth.pixels[i] = static_cast<float>(glm::distance(p, eye));
    }
    layers.push_back(std::move(depth));
    layers.push_back(std::move(position));
    layers.push_back(make_layer(normal_layer, samples, [&](std::size_t i) { return mean(&SurfaceSums::normal, i); }));
}

/// For independent sets s of n_s samples with means m_s, each with variance sigma^2 / n_s: the mean over all N = sum n_s samples has the
/// variance sigma^2 / N, and sigma^2 is estimated without bias by sum n_s (m_s - m)^2 / (sets - 1).
glm::dvec3 FilmSums::variance(std::size_t pixel, int samples, int sets) const {
    if (sets < 2) return glm::dvec3(0);
    const double n = samples;
    return glm::max((squares_[pixel] - total_[pixel] * total_[pixel] / n) / ((sets - 1) * n), glm::dvec3(0));
}

double FilmSums::relative_mean_square_error(const std::vector<int>& samples, const std::vector<int>& sets) const {
    if (ended_.empty() || *std::min_element(sets.begin(), sets.end()) < 2) return std::numeric_limits<double>::infinity();
    const auto values = static_cast<double>(3 * total_.size());
    double mean = 0, sum = 0;
    for (std::size_t i = 0; i < total_.size(); ++i) mean += glm::compAdd(total_[i]) / samples[i] / values;
    if (mean <= 0) return 0;
    for (std::size_t i = 0; i < total_.size(); ++i) {
        const glm::dvec3 value = total_[i] / static_cast<double>(samples[i]), square = variance(i, samples[i], sets[i]);
        for (int c = 0; c < 3; ++c) sum += square[c] / relative_to(value[c], mean);
    }
    return sum / values;
}

}  // namespace pencil
