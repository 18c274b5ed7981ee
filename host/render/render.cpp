#include "render/render.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/checkpoint.h"
#include "render/photometric_layers.h"
#include "render/render_session.h"
#include "util/archive.h"
#include "util/error.h"
#include "util/stopwatch.h"

namespace pencil {

namespace {

class CarefulRender {
public:
    CarefulRender(const Scene& scene, const RenderOptions& options, std::shared_ptr<Device> device, const Progress& progress,
                  const RenderCare& care)
        : scene_(scene), options_(options), device_(std::move(device)), progress_(progress), care_(care) {}

    RenderResult run() {
        std::string failure;
        while (true) try {
                begin();
                while (session_->advance()) write_checkpoint(false);
                write_checkpoint(true);
                break;
            } catch (const DeviceError& error) {
                if (move_on(error)) continue;
                failure = error.what();
                break;
            } catch (const MemoryError& error) {
                if (!failed_) throw;  // what another device has left does not fit this one
                failure = error.what();
                break;
            }
        if (!failure.empty() && !(session_ && session_->has_step())) session_ = std::move(failed_);
        if (!session_) throw DeviceError(failure);
        RenderResult result = session_->finish();
        result.failure = failure;
        result.stats.warnings.insert(result.stats.warnings.end(), warnings_.begin(), warnings_.end());
        return result;
    }

    /// That the render has ended on.
    const std::shared_ptr<Device>& device() const { return device_; }

private:
    /// A session on the device, which goes on from what there is.
    void begin() {
        std::vector<std::shared_ptr<Device>> helpers = care_.helpers;
        helpers.erase(std::remove(helpers.begin(), helpers.end(), device_), helpers.end());  // one that has taken over helps nobody
        session_ = std::make_unique<RenderSession>(scene_, options_, device_, progress_, helpers);
        if (!care_.checkpoint.empty() || !care_.resume.empty()) identity_ = render_identity(scene_, session_->options(), *device_);
        if (!state_.empty()) return session_->resume(state_);
        if (care_.resume.empty()) return;
        std::vector<char> state = read_checkpoint(care_.resume, identity_);
        try {
            session_->resume(std::move(state));
        } catch (const ArchiveError& error) {
            throw UsageError(fmt::format("--resume {}: it is damaged: {}", care_.resume.string(), error.what()));
        }
    }

    /// A disk that is full is no reason to lose the image.
    void write_checkpoint(bool last) {
        if (care_.checkpoint.empty() || !session_->has_step() || !(last || clock_.due())) return;
        const Stopwatch watch;
        try {
            pencil::write_checkpoint(care_.checkpoint, identity_, session_->save());
        } catch (const OutputError& error) {
            if (!warned_) warnings_.push_back(fmt::format("no checkpoint: {}", error.what()));
            warned_ = true;
        }
        clock_.written_in(watch.seconds());
    }

    /// To another device, with what was finished; the session that failed is kept until there is more.
    bool move_on(const DeviceError& error) {
        if (session_ && session_->has_step()) {
            if (session_->resumable()) state_ = session_->save();
            session_->let_go();
            failed_ = std::move(session_);
        }
        session_ = nullptr;
        std::shared_ptr<Device> next;
        try {
            if (care_.next_device) next = care_.next_device(*device_);
        } catch (const DeviceError&) {  // that one has failed, too
        }
        if (!next) return false;
        warnings_.push_back(fmt::format("{} failed: {}; {} goes on", device_->info().name, error.what(), next->info().name));
        device_ = next;
        return true;
    }

    const Scene& scene_;
    const RenderOptions& options_;
    std::shared_ptr<Device> device_;
    const Progress& progress_;
    const RenderCare& care_;
    std::unique_ptr<RenderSession> session_, failed_;
    RenderIdentity identity_;
    std::vector<char> state_;  // of a session whose device failed
    CheckpointClock clock_;
    bool warned_ = false;
    std::vector<std::string> warnings_;
};

}  // namespace

RenderResult render(const Scene& scene, const RenderOptions& options, const std::shared_ptr<Device>& device, const Progress& progress,
                    const RenderCare& care) {
    CarefulRender careful(scene, options, device, progress, care);
    RenderResult result = careful.run();
    const auto solve_irradiance = [&] {
        if (result.interrupted || !result.failure.empty()) return IrradianceImage{{}, {}, true, true};
        const Stopwatch watch;
        RenderResult found;
        try {
            found = CarefulRender(scene, irradiance_options(options), careful.device(), progress, {{}, {}, care.helpers, care.next_device})
                        .run();
        } catch (const DeviceError& error) {  // the image is there
            result.failure = error.what();
            return IrradianceImage{{}, {}, true, true};
        }
        result.stats.stages.push_back({illuminance_layer, watch.seconds(), 0, 0, {}});
        result.failure = found.failure;
        return IrradianceImage{std::move(found.layers), std::move(found.stats.warnings), found.interrupted, found.stats.converged};
    };
    const IrradianceImage irradiance =
        add_photometric_layers(options.aovs, resolve(options, scene).lumens_per_watt, solve_irradiance, result.layers);
    result.stats.warnings.insert(result.stats.warnings.end(), irradiance.warnings.begin(), irradiance.warnings.end());
    result.stats.converged = result.stats.converged && irradiance.converged;
    result.interrupted = result.interrupted || (irradiance.interrupted && result.failure.empty());
    return result;
}

}  // namespace pencil
