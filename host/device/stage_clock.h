// Wall and device time of the stages of a render. A stage ends by waiting for the device, so that its wall time is its own.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "cl/device.h"
#include "render/render.h"

namespace pencil {

class StageClock {
public:
    StageClock(std::shared_ptr<Device> device, const Progress& progress) : device_(std::move(device)), progress_(progress) {}

    /// Runs `work` as part of stage `name` (times of equal names add up) and returns its device seconds.
    template <typename Work>
    double run(const std::string& name, Work&& work) {
        announce(name);
        const auto start = std::chrono::steady_clock::now();
        const std::map<std::string, LaunchTimes> before = device_->launch_times();
        const double built = device_->build_seconds();
        work();
        device_->finish();
        const double build = device_->build_seconds() - built;
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
        StageTime& stage = find(name);
        stage.wall_seconds += wall.count() - build;
        const double device_seconds = add_launches(stage, before);
        if (build > 0) find("kernel build").wall_seconds += build;
        return device_seconds;
    }

    /// Reports progress; true if the caller asked to stop.
    bool stopped() const { return stopped_; }
    void set_fraction(double fraction) { fraction_ = fraction; }
    const std::vector<StageTime>& stages() const { return stages_; }

private:
    void announce(const std::string& name) {
        if (progress_ && !progress_(name, fraction_)) stopped_ = true;
    }
    /// Adds what was launched since `before` to the stage; returns its device seconds.
    double add_launches(StageTime& stage, const std::map<std::string, LaunchTimes>& before) {
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
    StageTime& find(const std::string& name) {
        for (StageTime& stage : stages_)
            if (stage.name == name) return stage;
        stages_.push_back({name, 0, 0, 0, {}});
        return stages_.back();
    }

    std::shared_ptr<Device> device_;
    Progress progress_;
    double fraction_ = 0;
    bool stopped_ = false;
    std::vector<StageTime> stages_;
};

}  // namespace pencil
