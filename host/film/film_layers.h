// The layers of the result: surface properties, emission, one layer per reflection, and their sum.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "device/device_scene.h"
#include "film/film.h"
#include "options/layer.h"
#include "pencils/flat_scene.h"

namespace pencil {

/// Mean over the pixels of an rgb image.
glm::dvec3 mean_rgb(const std::vector<float>& pixels);

class FilmLayers {
public:
    /// `aovs`: some of layer_groups(), or photometric layers, which are made elsewhere; others are a UsageError.
    explicit FilmLayers(const std::vector<std::string>& aovs);

    /// An image that is whole, instead of what there is: rgb per pixel.
    void show(std::vector<float> pixels) {
        *this = FilmLayers(std::vector<std::string>());
        beauty_ = std::move(pixels);
    }
    /// Emission (always part of the beauty) and the wanted properties of the surfaces.
    void add_surfaces(Kernels& kernels, const DeviceScene& scene, const FlatScene& flat, const Film& film);
    /// Reflection `order`: 1 is direct light ("direct"), 2 is "bounce2" and so on; indirect is all of them together ("indirect").
    static constexpr int indirect = -1;
    void add_bounce(int order, std::vector<float> pixels);
    /// So far, rgb per pixel: only emission after add_surfaces.
    const std::vector<float>& beauty() const { return beauty_; }
    /// Adds the last bounce times `factor` as the rest of the series (`tail_layer` of the next order). Returns its mean relative to the
    /// image's.
    double close_series(const glm::dvec3& factor);
    /// Beauty first, then the wanted layers in a fixed order. take() leaves nothing behind.
    std::vector<Layer> snapshot(int width, int height) const { return FilmLayers(*this).take(width, height); }
    std::vector<Layer> take(int width, int height);

private:
    bool wants(const std::string& aov) const { return aovs_.count(aov) > 0; }
    void add_to_beauty(const std::vector<float>& pixels);

    std::set<std::string> aovs_;
    std::vector<float> beauty_, last_bounce_;
    int last_order_ = 0;
    std::vector<Layer> light_, surface_;
};

}  // namespace pencil
