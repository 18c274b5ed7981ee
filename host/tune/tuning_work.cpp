#include "tune/tuning_work.h"

#include "render/render_session.h"
#include "stress/stress_scenes.h"

namespace pencil {
namespace {

/// Width of the image; half of that is its height [pixels].
constexpr int first_width = 128, last_width = 2048;
/// Of device time, so that single launches do not count [s].
constexpr double long_enough = 0.25;

RenderOptions tuning_options(MethodName method, int width) {
    RenderOptions options;
    options.method = method;
    options.aovs = {};
    options.width = width;
    options.height = width / 2;
    options.bounces = 3;
    options.target_error = 1e6;  // as few passes as may be
    options.pencils = method == MethodName::surface ? 400 : 64;
    options.map = 32;
    return options;
}

KernelTimes seconds_of(Device& device) {
    KernelTimes seconds;
    for (const auto& [kernel, times] : device.kernel_times()) seconds[kernel] = times.device_seconds;
    return seconds;
}

}  // namespace

TuningWork::TuningWork(std::shared_ptr<Device> device, Progress progress)
    : device_(std::move(device)), progress_(std::move(progress)), scene_(furnished_room()), width_(first_width) {}

void TuningWork::render(const RenderOptions& options, std::vector<float>& image) {
    RenderSession session(scene_, options, device_, progress_);
    while (session.advance()) {
    }
    if (session.interrupted()) throw TuneStopped();
    const RenderResult result = session.finish();
    image.insert(image.end(), result.layers.front().pixels.begin(), result.layers.front().pixels.end());
}

Sample TuningWork::run(const DeviceProfile& profile) {
    device_->set_profile(profile);
    const KernelTimes before = seconds_of(*device_);
    Sample sample;
    for (const MethodName method : {MethodName::surface, MethodName::line}) render(tuning_options(method, width_), sample.image);
    sample.seconds = seconds_of(*device_);
    for (const auto& [kernel, seconds] : before) sample.seconds[kernel] -= seconds;
    return sample;
}

void TuningWork::fit(const DeviceProfile& profile) {
    run(profile);  // code is made
    while (width_ < last_width && sum_of(run(profile).seconds, {}) < long_enough) width_ *= 2;
}

}  // namespace pencil
