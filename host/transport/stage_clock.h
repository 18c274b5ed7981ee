// Wall and device time of the stages of a render. A stage ends by waiting for the device, so that its wall time is its own.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "cl/device.h"
#include "transport/render.h"

namespace pencil {

class StageClock {
public:
    StageClock(std::shared_ptr<Device> device, const Progress& progress) : device_(std::move(device)), progress_(progress) {}

    /// Runs `work` as part of stage `name` (times of equal names add up) and returns its device seconds.
    template <typename Work>
    double run(const std::string& name, Work&& work) {
        announce(name);
        const auto start = std::chrono::steady_clock::now();
        const LaunchTimes before = total();
        const double built = device_->build_seconds();
        work();
        device_->finish();
        const LaunchTimes after = total();
        const double build = device_->build_seconds() - built;
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
        StageTime& stage = find(name);
        stage.wall_seconds += wall.count() - build;
        stage.device_seconds += after.device_seconds - before.device_seconds;
        stage.launches += after.launches - before.launches;
        if (build > 0) find("kernel build").wall_seconds += build;
        return after.device_seconds - before.device_seconds;
    }

    /// Reports progress; true if the caller asked to stop.
    bool stopped() const { return stopped_; }
    void set_fraction(double fraction) { fraction_ = fraction; }
    const std::vector<StageTime>& stages() const { return stages_; }

private:
    void announce(const std::string& name) {
        if (progress_ && !progress_(name, fraction_)) stopped_ = true;
    }
    LaunchTimes total() {
        LaunchTimes sum;
        for (const auto& [description, times] : device_->launch_times()) {
            sum.launches += times.launches;
            sum.device_seconds += times.device_seconds;
        }
        return sum;
    }
    StageTime& find(const std::string& name) {
        for (StageTime& stage : stages_)
            if (stage.name == name) return stage;
        stages_.push_back({name, 0, 0, 0});
        return stages_.back();
    }

    std::shared_ptr<Device> device_;
    Progress progress_;
    double fraction_ = 0;
    bool stopped_ = false;
    std::vector<StageTime> stages_;
};

}  // namespace pencil
