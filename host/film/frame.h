// One image in the making: the film and its surfels, the light samples, direct light, and the layers that reflections are added to.
#pragma once

#include <memory>

#include "pencils/light_samples.h"
#include "film/film.h"
#include "film/film_layers.h"
#include "device/pencil_set.h"
#include "device/stage_clock.h"
#include "device/turn.h"

namespace pencil {

/// Width of the maps of light samples beside pencil maps of width `map`.
int light_map_size(int map);

/// What is made once per render, whatever the method and however many frames it takes.
struct RenderContext {
    RenderContext(const Scene& scene, const RenderOptions& options, const std::shared_ptr<Device>& device, const Progress& progress);

    /// Reflections of order `order` are part of the image (1 is direct light).
    bool wanted(int order) const { return options.bounces < 0 || order <= options.bounces; }

    const Scene& scene;
    RenderOptions options;
    std::vector<LightForm> forms;
    FlatScene flat;
    Kernels kernels;
    StageClock clock;
    std::vector<MapBatch> batches;  // geometry maps that will be made, as far as can be told
    Prepared prepared;
    DeviceScene device_scene;
    bool maps_emit = false;  // some emitter is carried by the maps
    RenderStats stats;
};

class Frame {
public:
    /// Makes film geometry, light samples with their maps, and the surface layers.
    Frame(RenderContext& context, const std::vector<std::string>& aovs, int light_samples, int light_map, const Turn& turn);

    /// True if no light reaches anything: no light sample, no emitter carried by the maps.
    bool dark() const { return lights_.maps.count == 0 && !context_.maps_emit; }

    /// Direct light of the light samples goes into outgoing(), and is finished as order 1 unless maps carry more of it.
    void add_direct();

    /// Adds what outgoing() holds as the reflection of this order to the layers, and clears it. `pencils`: size of the set that carried it.
    void finish_bounce(int order, int pencils, double projection_seconds);

    const Film& film() const { return *film_; }
    const LightSet& lights() const { return lights_; }
    const std::vector<LightSample>& light_samples() const { return samples_; }
    Buffer<float>& outgoing() { return outgoing_; }  // rgb per surfel of the film
    FilmLayers& layers() { return layers_; }
    std::vector<Layer> take_layers() { return layers_.take(film_->width(), film_->height()); }

private:
    void make_lights(int samples, int map, const Turn& turn);

    RenderContext& context_;
    FilmLayers layers_;
    std::unique_ptr<Film> film_;
    std::vector<LightSample> samples_;
    LightSet lights_;
    Buffer<float> outgoing_;
};

}  // namespace pencil
