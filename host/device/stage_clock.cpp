#include "device/stage_clock.h"

namespace pencil {

void StageClock::poll() {
    if (progress_ && !progress_(stage_, fraction_)) stopped_ = true;
    if (stopped_ && !held_) throw Stopped();
}

double StageClock::close(const std::string& name, const Mark& start) {
    device_->finish();
    const double wall = watch_.seconds() - start.wall, build = device_->build_seconds() - start.built;
    StageTime& stage = find(name);
    stage.wall_seconds += wall - build;
    const double device_seconds = add_launches(stage, start.launches);
    if (build > 0) find("kernel build").wall_seconds += build;
    return device_seconds;
}

/// Adds what was launched since `before` to the stage; returns its device seconds.
double StageClock::add_launches(StageTime& stage, const std::map<std::string, LaunchTimes>& before) {
    double seconds = 0;
    for (const auto& [description, times] : device_->launch_times()) {
        const auto old = before.find(description);
        const LaunchTimes earlier = old == before.end() ? LaunchTimes{} : old->second;
        if (times.launches == earlier.launches) continue;
        LaunchTimes& kernel = stage.kernels[description];
        kernel.launches += times.launches - earlier.launches;
        kernel.device_seconds += times.device_seconds - earlier.device_seconds;
        stage.launches += times.launches - earlier.launches;
        seconds += times.device_seconds - earlier.device_seconds;
    }
    stage.device_seconds += seconds;
    return seconds;
}

StageTime& StageClock::find(const std::string& name) {
    for (StageTime& stage : stages_)
        if (stage.name == name) return stage;
    stages_.push_back({name, 0, 0, 0, {}});
    return stages_.back();
}

}  // namespace pencil
