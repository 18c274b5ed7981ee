#include "surface/gather_team.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>

#include "util/stopwatch.h"

namespace pencil {

namespace {

/// Pencils that a device takes at once before its speed is known, and at least.
constexpr int least_part = 64;
/// Of what is left of a set each device takes this share of what it would do of it: all end at about the same time.
constexpr double part_share = 0.5;

struct Part {
    int first, count;
};

/// The parts of a set that nobody has taken yet. Thread-safe.
class Parts {
public:
    /// Of `count` pencils, for so many devices.
    Parts(int count, std::size_t devices) : end_(count), speeds_(devices, 0.0) {}

    std::optional<Part> take(std::size_t device) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!returned_.empty()) {
            const Part part = returned_.back();
            returned_.pop_back();
            return part;
        }
        if (next_ >= end_) return {};
        const Part part{next_, std::min(size_for(device), end_ - next_)};
        next_ += part.count;
        return part;
    }
    /// The device has done so many pencils in so many seconds.
    void done(std::size_t device, int count, double seconds) {
        const std::lock_guard<std::mutex> lock(mutex_);
        speeds_[device] = count / std::max(seconds, 1e-9);
    }
    void give_back(const Part& part) {
        const std::lock_guard<std::mutex> lock(mutex_);
        returned_.push_back(part);
    }
    void close() {
        const std::lock_guard<std::mutex> lock(mutex_);
        next_ = end_;
        returned_.clear();
    }

private:
    /// Devices whose speed is not known count as this one.
    int size_for(std::size_t device) const {
        const double own = speeds_[device];
        double all = 0;
        for (const double speed : speeds_) all += speed > 0 ? speed : own;
        return own > 0 ? std::max(static_cast<int>(part_share * own / all * (end_ - next_)), least_part) : least_part;
    }

    std::mutex mutex_;
    int next_ = 0, end_;
    std::vector<double> speeds_;  // [pencils / s], 0: not known
    std::vector<Part> returned_;
};

/// Threads that end before what they work on does, however that is left.
class Crew {
public:
    explicit Crew(Parts& parts) : parts_(parts) {}
    ~Crew() {
        parts_.close();
        for (std::thread& thread : threads_) thread.join();
    }
    template <typename Work>
    void start(Work work) {
        threads_.emplace_back([this, work = std::move(work)]() mutable {
            work();
            ++ended_;
        });
    }
    bool has_ended() const { return ended_ == threads_.size(); }

private:
    Parts& parts_;
    std::vector<std::thread> threads_;
    std::atomic<std::size_t> ended_{0};
};

std::string name_of(const Kernels& kernels) {
    const DeviceInfo& info = kernels.device()->info();
    return fmt::format("{} {}", info.index, info.name);
}

/// What a helper has done of a set.
struct Done {
    std::vector<Part> parts;
    std::uint64_t pencils = 0;
};

}  // namespace

GatherHelper::GatherHelper(DeviceCopy& copy, SurfaceLights lights, int light_draws, int texels)
    : copy_(copy), lights_(std::move(lights)), gatherer_(copy.kernels, copy.scene, lights_, light_draws, texels) {}

void GatherHelper::take_world(const HostWorld& world) {
    const auto& device = copy_.kernels.device();
    world_ = SurfacePencils();
    world_.count = static_cast<int>(world.pencils.size());
    world_.n = world.n;
    world_.data = Buffer<SurfacePencil>(device, world.pencils, "surface pencils");
    world_.irradiance = Buffer<float4>(device, world.irradiance, "irradiance of surface pencils");
    shorter_ = world.shorter.empty() ? Buffer<float4>() : Buffer<float4>(device, world.shorter, "irradiance of fewer bounces");
    grid_ = DeviceGrid(device, world.pencils);
    spots_ = DeviceSpots(device, world.spots);
    direct_ = world.direct;
    contacts_ = world.contacts;
}

void GatherHelper::gather(const GatherTurn& turn, int n, int first, int count, std::vector<SurfacePencil>& data,
                          std::vector<float4>& irradiance) {
    SurfacePencils pencils(copy_.kernels.device(), count, n);
    pencils.count = count;
    const auto begin = data.begin() + first;
    pencils.data.write(std::vector<SurfacePencil>(begin, begin + count));
    gatherer_.gather({world_, shorter_, grid_, spots_.count > 0 ? &spots_ : nullptr, direct_, contacts_}, turn, pencils, 0, count);
    const std::vector<SurfacePencil> seen = pencils.data.read(0, static_cast<std::size_t>(count));
    const std::vector<float4> sums = pencils.irradiance.read(0, static_cast<std::size_t>(count));
    std::copy(seen.begin(), seen.end(), begin);
    std::copy(sums.begin(), sums.end(), irradiance.begin() + first);
}

void GatherTeam::add(DeviceCopy& copy, const std::function<std::unique_ptr<GatherHelper>()>& make) {
    try {
        helpers_.push_back(make());
    } catch (const std::exception& error) {
        copy.failure = error.what();
        dismiss(copy);
    }
}

void GatherTeam::dismiss(const DeviceCopy& copy) {
    report_.notes.push_back(fmt::format("device {} helps no more: {}", name_of(copy.kernels), copy.failure));
}

void GatherTeam::take_world(const HostWorld& world) {
    for (const auto& helper : helpers_) try {
            helper->take_world(world);
        } catch (const std::exception& error) {
            helper->copy().failure = error.what();
        }
    dismiss_failed();
}

void GatherTeam::dismiss_failed() {
    for (const auto& helper : helpers_)
        if (!helper->copy().failure.empty()) dismiss(helper->copy());
    helpers_.erase(std::remove_if(helpers_.begin(), helpers_.end(), [](const auto& helper) { return !helper->copy().failure.empty(); }),
                   helpers_.end());
}

void GatherTeam::gather(Gatherer& own, const GatherSource& source, const GatherTurn& turn, SurfacePencils& pencils, int first, int count) {
    if (alone() && !report_.pencils.empty()) report_.pencils[name_of(kernels_)] += static_cast<std::uint64_t>(count);
    if (alone() || count == 0) return own.gather(source, turn, pencils, first, count);
    const auto from = static_cast<std::size_t>(first), number = static_cast<std::size_t>(count);
    std::vector<SurfacePencil> data = pencils.data.read(from, number);
    std::vector<float4> irradiance(number);
    const std::size_t me = helpers_.size();
    Parts parts(count, helpers_.size() + 1);
    std::vector<Done> done(helpers_.size());
    // However this ends, it is said which have failed.
    struct AtEnd {
        GatherTeam& team;
        ~AtEnd() { team.dismiss_failed(); }
    } at_end{*this};
    const auto help = [&](std::size_t k, std::optional<Part> part) {
        for (; part; part = parts.take(k)) try {
                const Stopwatch watch;
                helpers_[k]->gather(turn, pencils.n, part->first, part->count, data, irradiance);
                parts.done(k, part->count, watch.seconds());
                done[k].parts.push_back(*part);
                done[k].pencils += static_cast<std::uint64_t>(part->count);
            } catch (const std::exception& error) {
                parts.give_back(*part);
                helpers_[k]->copy().failure = error.what();
                return;
            }
    };
    std::uint64_t by_own = 0;
    const auto work = [&] {
        while (const std::optional<Part> part = parts.take(me)) {
            const Stopwatch watch;
            own.gather(source, turn, pencils, first + part->first, part->count);
            parts.done(me, part->count, watch.seconds());
            by_own += static_cast<std::uint64_t>(part->count);
        }
    };
    Crew crew(parts);
    for (std::size_t k = 0; k < helpers_.size(); ++k) {
        // Each has its first part before anybody begins: none goes without because another was faster to start.
        const std::optional<Part> part = parts.take(k);
        try {
            crew.start([&help, k, part] { help(k, part); });
        } catch (const std::system_error& error) {
            if (part) parts.give_back(*part);
            helpers_[k]->copy().failure = error.what();
        }
    }
    work();
    while (!crew.has_ended()) {
        kernels_.poll();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    work();  // what a helper that failed has left
    report_.pencils[name_of(kernels_)] += by_own;
    for (std::size_t k = 0; k < helpers_.size(); ++k) {
        report_.pencils[name_of(helpers_[k]->copy().kernels)] += done[k].pencils;
        for (const Part& part : done[k].parts) {
            const auto begin = static_cast<std::ptrdiff_t>(part.first), end = begin + part.count;
            pencils.data.write(std::vector<SurfacePencil>(data.begin() + begin, data.begin() + end),
                               from + static_cast<std::size_t>(begin));
            pencils.irradiance.write(std::vector<float4>(irradiance.begin() + begin, irradiance.begin() + end),
                                     from + static_cast<std::size_t>(begin));
        }
    }
}

}  // namespace pencil
