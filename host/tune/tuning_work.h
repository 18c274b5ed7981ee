// The work that devices are tuned by: a small furnished room, rendered by surface pencils and by line projection.
#pragma once

#include <memory>

#include "options/render_options.h"
#include "options/render_result.h"
#include "scene/scene.h"
#include "tune/trial.h"

namespace pencil {

class Device;

/// A tuning that was interrupted.
struct TuneStopped {};

class TuningWork {
public:
    /// `progress` is asked whether to go on; TuneStopped.
    TuningWork(std::shared_ptr<Device> device, Progress progress);

    /// Both renders with a profile, which the device keeps.
    Sample run(const DeviceProfile& profile);
    /// Makes the image larger until a run keeps the device busy for long enough to be measured.
    void fit(const DeviceProfile& profile);
    int width() const { return width_; }

private:
    void render(const RenderOptions& options, std::vector<float>& image);
    std::shared_ptr<Device> device_;
    Progress progress_;
    Scene scene_;
    int width_;
};

}  // namespace pencil
