#include "film/film_layers.h"

#include <algorithm>

#include "film/emit_surfels.h"
#include "options/option_values.h"
#include "util/error.h"

namespace pencil {

namespace {

/// Pixels with less of a surface than this have no position: filters with negative lobes would divide by next to nothing.
constexpr float least_cover = 1e-3F;

/// World positions of pixels, and distances from the camera along the pixel's ray; empty pixels keep 0. The filter also averages over what
/// is empty: `cover`, its share of each pixel that shows a surface (rgb alike; empty: all of all), scales positions back to the covered
/// part.
void to_world(const FlatScene& flat, const std::vector<float>& cover, std::vector<float>& position, std::vector<float>& depth) {
    const glm::dvec3 eye = flat.normalisation.to_world(flat.eye);
    depth.assign(position.size() / 3, 0.0F);
    for (std::size_t i = 0; i < depth.size(); ++i) {
        const float covered = cover.empty() ? 1.0F : cover[3 * i];
        glm::dvec3 p(position[3 * i], position[3 * i + 1], position[3 * i + 2]);
        if (covered < least_cover) {
            for (std::size_t c = 0; c < 3; ++c) position[3 * i + c] = 0.0F;
            continue;
        }
        p = flat.normalisation.to_world(covered == 1.0F ? p : p / static_cast<double>(covered));
        for (int c = 0; c < 3; ++c) position[3 * i + static_cast<std::size_t>(c)] = static_cast<float>(p[c]);
        depth[i] = static_cast<float>(glm::length(p - eye));
    }
}

}  // namespace

glm::dvec3 mean_rgb(const std::vector<float>& pixels) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i + 2 < pixels.size(); i += 3) sum += glm::dvec3(pixels[i], pixels[i + 1], pixels[i + 2]);
    return pixels.empty() ? sum : sum / (static_cast<double>(pixels.size()) / 3.0);
}

FilmLayers::FilmLayers(const std::vector<std::string>& aovs) : aovs_(aovs.begin(), aovs.end()) {
    for (const std::string& aov : aovs)
        if (!has_group(layer_groups(), aov) && !has_group(photometric_layers(), aov))
            throw UsageError("unknown layer \"" + aov + "\"; known: " + join(layer_groups()));
}

void FilmLayers::add_surfaces(Kernels& kernels, const DeviceScene& scene, const FlatScene& flat, const Film& film) {
    const Surfels& surfels = film.surfels();
    Buffer<float> emission = surfel_rgb(kernels.device(), surfels.capacity, "emission of the film");
    emit_surfels(kernels, scene, surfels, false, emission);
    if (const CloseUps& close = film.close_ups(); close.each > 0) {
        Buffer<float> of_close = surfel_rgb(kernels.device(), close.surfels.capacity, "emission of close-ups");
        emit_surfels(kernels, scene, close.surfels, false, of_close);
        average_close_ups(kernels, close, film.first_surfel(), of_close, emission, surfels.capacity);
    }
    if (kernels.features().sky && film.has_empty()) {
        const Buffer<float> sky = film.sky(kernels, scene);
        beauty_ = film.resolve(kernels, emission, &sky);
    } else {
        beauty_ = film.resolve(kernels, emission);
    }
    if (wants(emission_layer)) light_.push_back({emission_layer, 3, beauty_});
    if (wants(albedo_layer)) surface_.push_back({albedo_layer, 3, film.resolve_fields(kernels, SURFEL_ALBEDO_R)});
    if (wants(depth_layer) || wants(position_layer)) {
        std::vector<float> position = film.resolve_fields(kernels, SURFEL_X), depth;
        to_world(flat, film.has_empty() ? film.cover(kernels) : std::vector<float>(), position, depth);
        if (wants(depth_layer)) surface_.push_back({depth_layer, 1, std::move(depth)});
        if (wants(position_layer)) surface_.push_back({position_layer, 3, std::move(position)});
    }
    if (wants(normal_layer)) surface_.push_back({normal_layer, 3, film.resolve_fields(kernels, SURFEL_NX)});
}

void FilmLayers::add_to_beauty(const std::vector<float>& pixels) {
    std::transform(
        beauty_.begin(), beauty_.end(), pixels.begin(), beauty_.begin(), [](float a, float b) { return a + b; });
}

void FilmLayers::add_bounce(int order, std::vector<float> pixels) {
    add_to_beauty(pixels);
    if (wants(order == 1 ? direct_layer : bounces_group))
        light_.push_back({order == indirect ? indirect_layer : bounce_layer(order), 3, pixels});
    last_bounce_ = std::move(pixels);
    last_order_ = order;
}

double FilmLayers::close_series(const glm::dvec3& factor) {
    for (std::size_t i = 0; i < last_bounce_.size(); ++i) last_bounce_[i] *= static_cast<float>(factor[static_cast<int>(i % 3)]);
    add_to_beauty(last_bounce_);
    const glm::dvec3 tail = mean_rgb(last_bounce_), image = mean_rgb(beauty_);
    if (wants(bounces_group)) light_.push_back({tail_layer(last_order_ + 1), 3, std::move(last_bounce_)});
    const double sum = image.x + image.y + image.z;
    return sum > 0 ? (tail.x + tail.y + tail.z) / sum : 0.0;
}

std::vector<Layer> FilmLayers::take(int width, int height) {
    beauty_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    std::vector<Layer> layers = {{"", 3, std::move(beauty_)}};
    for (std::vector<Layer>* group : {&light_, &surface_})
        for (Layer& layer : *group) layers.push_back(std::move(layer));
    return layers;
}

}  // namespace pencil
