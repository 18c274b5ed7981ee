// What is made once per render, whatever the method and however many steps it takes.
#pragma once

#include <algorithm>
#include <memory>

#include "device/device_scene.h"
#include "device/features.h"
#include "device/stage_clock.h"
#include "film/device_copy.h"
#include "film/method.h"
#include "options/render_options.h"
#include "options/render_result.h"
#include "pencils/flat_scene.h"
#include "pencils/light_samples.h"
#include "scene/scene.h"

namespace pencil {

/// RenderOptions::bounces of a scene's max_depth, which counts the emitter as the first vertex of a path.
inline int scene_bounces(const Scene& scene) { return scene.max_depth < 0 ? endless_bounces : std::max(scene.max_depth - 1, 0); }

/// What the method of `options` needs for this scene; `forms`: how each shape's light enters.
using NeedsOf = MethodNeeds (*)(const Scene& scene, const std::vector<LightForm>& forms, const RenderOptions& options);

struct RenderContext {
    /// `options`: complete, nothing left to the scene or the method. `scene` must outlive the context.
    /// `helping`: devices that share the work of the first; those that the scene does not fit are left out with a warning.
    RenderContext(const Scene& scene, const RenderOptions& options, NeedsOf needs_of, const std::shared_ptr<Device>& device,
                  const Progress& progress, const std::vector<std::shared_ptr<Device>>& helping = {});
    RenderContext(const RenderContext&) = delete;
    RenderContext& operator=(const RenderContext&) = delete;

    /// Reflections of order `order` are part of the image (1 is direct light).
    bool wanted(int order) const { return options.bounces < 0 || order <= options.bounces; }

    const Scene& scene;
    const RenderOptions options;
    StageClock clock;
    std::vector<LightForm> forms;
    FlatScene flat;
    MethodNeeds needs;
    Kernels kernels;
    Prepared prepared;
    HelperReport helpers;
    std::vector<std::unique_ptr<DeviceCopy>> copies;  // of devices that help
    DeviceScene device_scene;
    bool maps_emit = false;                // some emitter is carried by the maps
    RenderStats stats;                     // as far as methods fill them; the session adds the rest
    std::vector<LightReceiver> receivers;  // some of what the first film shows, where light samples depend on it
    std::vector<float> light_importance;   // of the emitters' triangles for these
};

}  // namespace pencil
