#include "surface/gather_team.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <optional>
#include <thread>

#include "util/error.h"

namespace pencil {

namespace {

/// Parts that each device takes of a set, about, and pencils of one at least: small ones keep all busy to the end, large ones cost fewer launches.
constexpr int parts_each = 4, least_part = 64;

struct Part {
    int first, count;
};

/// The parts of a set that nobody has taken yet. Thread-safe.
class Parts {
public:
    Parts(int first, int count, int size) : next_(first), end_(first + count), size_(size) {}

    std::optional<Part> take() {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!returned_.empty()) {
            const Part part = returned_.back();
            returned_.pop_back();
            return part;
        }
        if (next_ >= end_) return {};
        const Part part{next_, std::min(size_, end_ - next_)};
        next_ += part.count;
        return part;
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
    std::mutex mutex_;
    int next_, end_, size_;
    std::vector<Part> returned_;
};

/// Threads that end before what they work on does, however that is left.
class Crew {
public:
    explicit Crew(Parts& parts) : parts_(parts) {}
    ~Crew() {
        parts_.close();
        join();
    }
    template <typename Work>
    void start(Work work) {
        threads_.emplace_back(std::move(work));
    }
    void join() {
        for (std::thread& thread : threads_) thread.join();
        threads_.clear();
    }

private:
    Parts& parts_;
    std::vector<std::thread> threads_;
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
    } catch (const Error& error) {
        copy.failure = error.what();
        report(copy);
    }
}

void GatherTeam::report(const DeviceCopy& copy) {
    stats_.warnings.push_back(fmt::format("device {} helps no more: {}", name_of(copy.kernels), copy.failure));
}

void GatherTeam::take_world(const HostWorld& world) {
    for (const auto& helper : helpers_) try {
            helper->take_world(world);
        } catch (const Error& error) {
            helper->copy().failure = error.what();
        }
    dismiss_failed();
}

void GatherTeam::dismiss_failed() {
    for (const auto& helper : helpers_)
        if (!helper->copy().failure.empty()) report(helper->copy());
    helpers_.erase(std::remove_if(helpers_.begin(), helpers_.end(), [](const auto& helper) { return !helper->copy().failure.empty(); }),
                   helpers_.end());
}

void GatherTeam::gather(Gatherer& own, const GatherSource& source, const GatherTurn& turn, SurfacePencils& pencils, int first, int count) {
    if (alone() || count == 0) return own.gather(source, turn, pencils, first, count);
    const auto from = static_cast<std::size_t>(first), number = static_cast<std::size_t>(count);
    std::vector<SurfacePencil> data = pencils.data.read(from, number);
    std::vector<float4> irradiance(number);
    Parts parts(0, count, std::max(count / (parts_each * (static_cast<int>(helpers_.size()) + 1)), least_part));
    std::vector<Done> done(helpers_.size());
    Crew crew(parts);
    for (std::size_t k = 0; k < helpers_.size(); ++k)
        // Each has its first part before anybody begins: none goes without because another was faster to start.
        crew.start([&, k, part = parts.take()]() mutable {
            for (; part; part = parts.take()) try {
                    helpers_[k]->gather(turn, pencils.n, part->first, part->count, data, irradiance);
                    done[k].parts.push_back(*part);
                    done[k].pencils += static_cast<std::uint64_t>(part->count);
                } catch (const std::exception& error) {
                    parts.give_back(*part);
                    helpers_[k]->copy().failure = error.what();
                    return;
                }
        });
    std::uint64_t by_own = 0;
    const auto work = [&] {
        while (const std::optional<Part> part = parts.take()) {
            own.gather(source, turn, pencils, first + part->first, part->count);
            by_own += static_cast<std::uint64_t>(part->count);
        }
    };
    work();
    crew.join();
    work();  // what a helper that failed has left
    stats_.device_pencils[name_of(kernels_)] += by_own;
    for (std::size_t k = 0; k < helpers_.size(); ++k) {
        stats_.device_pencils[name_of(helpers_[k]->copy().kernels)] += done[k].pencils;
        for (const Part& part : done[k].parts) {
            const auto begin = static_cast<std::ptrdiff_t>(part.first), end = begin + part.count;
            pencils.data.write(std::vector<SurfacePencil>(data.begin() + begin, data.begin() + end),
                               from + static_cast<std::size_t>(begin));
            pencils.irradiance.write(std::vector<float4>(irradiance.begin() + begin, irradiance.begin() + end),
                                     from + static_cast<std::size_t>(begin));
        }
    }
    dismiss_failed();
}

}  // namespace pencil
