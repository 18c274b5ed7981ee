// Wall and device time of the stages of a render, and the place where it is stopped. A stage ends by waiting for the device, so that its
// wall time is its own.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cl/device.h"
#include "options/render_result.h"
#include "util/stopwatch.h"

namespace pencil {

/// Thrown between launches when the caller has asked to stop.
struct Stopped {};

class StageClock {
public:
    StageClock(std::shared_ptr<Device> device, const Progress& progress)
        : device_(std::move(device)), progress_(progress), built_before_(device_->build_seconds()) {}

    /// Runs `work` as part of stage `name` (times of equal names add up) and returns its device seconds.
    template <typename Work>
    double run(const std::string& name, Work&& work) {
        stage_ = name;
        poll();
        const Mark start = mark();
        try {
            work();
        } catch (const Stopped&) {
            close(name, start);  // what was done is part of the report
            throw;
        }
        return close(name, start);
    }

    /// Reports progress. Once the caller has asked to stop, throws Stopped, unless stops are still held.
    void poll();
    /// From here on there is an image to stop with.
    void allow_stops() { held_ = false; }
    bool stopped() const { return stopped_; }

    void set_fraction(double fraction) { fraction_ = fraction; }
    /// Since the start, but for building kernels on the first device: that is the driver's time, and none once its cache is warm.
    double seconds() const { return earlier_ + watch_.seconds() - (device_->build_seconds() - built_before_); }
    /// The render began so many seconds earlier.
    void go_on_after(double seconds) { earlier_ = seconds; }
    const std::vector<StageTime>& stages() const { return stages_; }

private:
    /// Where clocks and counters stood when a stage began.
    struct Mark {
        double wall, built;
        std::map<std::string, LaunchTimes> launches;
    };

    Mark mark() { return {watch_.seconds(), device_->build_seconds(), device_->launch_times()}; }
    double close(const std::string& name, const Mark& start);
    double add_launches(StageTime& stage, const std::map<std::string, LaunchTimes>& before);
    StageTime& find(const std::string& name);

    std::shared_ptr<Device> device_;
    Progress progress_;
    double built_before_;  // seconds of kernel builds for earlier renders on the device
    double earlier_ = 0;   // seconds that the render took before it was interrupted
    Stopwatch watch_;
    std::string stage_;
    double fraction_ = 0;
    bool stopped_ = false, held_ = true;
    std::vector<StageTime> stages_;
};

}  // namespace pencil
