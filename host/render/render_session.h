// The product's main job: a scene and options in, layers out, a step at a time. Everything between runs in kernels.
#pragma once

#include <memory>
#include <vector>

#include "cl/device.h"
#include "options/render_options.h"
#include "options/render_result.h"
#include "scene/scene.h"

namespace pencil {

class Method;
struct RenderContext;

/// `options` with everything settled that they leave to the method or to the scene: pencils, bounces, size.
RenderOptions resolve(const RenderOptions& options, const Scene& scene);

/// The only owner of a solve. Not thread-safe.
class RenderSession {
public:
    /// `scene` must outlive the session. `helpers`: devices that share the work; the image is the same. `progress` is called between launches and may stop the work. UsageError for options out of range,
    /// MemoryError if the film alone does not fit the device, DeviceError.
    RenderSession(const Scene& scene, const RenderOptions& options, const std::shared_ptr<Device>& device, const Progress& progress = {},
                  const std::vector<std::shared_ptr<Device>>& helpers = {});
    ~RenderSession();
    RenderSession(const RenderSession&) = delete;
    RenderSession& operator=(const RenderSession&) = delete;

    /// One step: a pass of the surface method, a bounce of the line method. False if it was the last, or stopped, and ever after: what is
    /// finished stays.
    bool advance();
    /// The image from another pinhole, of the same size, by the light that is there: for fields, once they have been shown. UsageError for all else,
    /// which changes nothing. Stopped, the image is of no use.
    void look(const PerspectiveSensor& sensor);

    /// The image as far as it has come, beauty first; empty before the first step.
    std::vector<Layer> snapshot() const;
    /// Estimated relMSE of the beauty, infinite if not known.
    double estimated_error() const;
    RenderStats stats() const;
    bool interrupted() const;

    const RenderOptions& options() const;  // resolved

    bool resumable() const;
    /// A step was finished, here or by the session that this one goes on from.
    bool has_step() const { return has_step_; }
    /// What another session of the same scene and options needs to go on from the last finished step, of which there must be one. UsageError
    /// for a method whose steps do not stand alone.
    std::vector<char> save();
    /// Goes on from there, before any step: further steps give what they would have given there. Options may ask for more time or a smaller
    /// error. ArchiveError if it is nothing that save() gave; the session is of no use then.
    void resume(std::vector<char> state);

    /// Gives back what the next step would need on the devices: the session ends here, with what is finished.
    void let_go();

    /// Layers and stats; the session ends here.
    RenderResult finish();

private:
    std::unique_ptr<RenderContext> context_;
    std::unique_ptr<Method> method_;
    bool ended_ = false, complete_ = false;  // by itself
    bool has_step_ = false;
};

}  // namespace pencil
