// One image in the making: the film and its surfels, the light samples, direct light, and the layers that reflections are added to.
#pragma once

#include <functional>
#include <memory>

#include "device/pencil_set.h"
#include "device/turn.h"
#include "film/film.h"
#include "film/film_layers.h"
#include "film/render_context.h"
#include "pencils/light_samples.h"

namespace pencil {

class Frame {
public:
    /// Makes film geometry, light samples with their maps of width `light_map` (0: none), and the surface layers; `split`: Film's.
    Frame(RenderContext& context, const std::vector<std::string>& aovs, int light_samples, int light_map, const Turn& turn,
          const std::vector<unsigned char>& split = {});

    /// The film once more, from the camera that the scene has now; lights stay. outgoing() gets emission and the direct light of light samples.
    void look(const Turn& turn);
    /// outgoing() is the image: one layer, the beauty.
    void finish_look();

    /// Direct light of the light samples goes into outgoing(), and is finished as order 1 unless maps carry more of it. False if nothing
    /// can be added: no light, or no reflections wanted. `light` adds it instead of light_surfels.
    bool add_direct(const std::function<void()>& light = {});

    /// Adds what outgoing() holds as the reflection of this order to the layers, and clears it. `pencils`: size of the set that carried it.
    void finish_bounce(int order, int pencils, double projection_seconds);

    const Film& film() const { return *film_; }
    const std::vector<LightSample>& light_samples() const { return samples_; }
    const LightSet& lights() const { return lights_; }
    Buffer<float>& outgoing() { return outgoing_; }  // rgb per surfel of the film
    FilmLayers& layers() { return layers_; }
    const FilmLayers& layers() const { return layers_; }
    std::vector<Layer> snapshot() const { return layers_.snapshot(film_->width(), film_->height()); }
    std::vector<Layer> take_layers() { return layers_.take(film_->width(), film_->height()); }

private:
    void make_lights(int samples, int map, const Turn& turn);
    void light_close_ups();
    /// True if no light reaches anything: no light sample, no emitter carried by the maps.
    bool dark() const { return lights_.maps.count == 0 && !context_.maps_emit && !context_.options.field; }

    RenderContext& context_;
    FilmLayers layers_;
    std::unique_ptr<Film> film_;
    std::vector<LightSample> samples_;
    LightSet lights_;
    Buffer<float> outgoing_;
};

}  // namespace pencil
