// `pencil tune`: measures variants of the kernels on a device and keeps what is faster, for all renders on it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/message.h"
#include "cl/profile_file.h"
#include "cl/texel_image.h"
#include "tune/tune_maps.h"
#include "tune/tuning_work.h"
#include "util/log.h"

namespace pencil {
namespace {

std::string outcome(const TuneRow& row) {
    if (row.outcome.empty()) return "no";
    return row.outcome == "kept" ? "yes" : "refused: " + row.outcome;
}

void print_rows(const std::vector<TuneRow>& rows) {
    std::size_t kernels = 6, variant = 7;  // of the words above the columns
    for (const TuneRow& row : rows) {
        kernels = std::max(kernels, row.kernels.size());
        variant = std::max(variant, row.variant.size());
    }
    const auto print = [&](const std::string& a, const std::string& b, const std::string& c, const std::string& d) {
        std::cout << fmt::format("{:<{}}  {:<{}}  {:>10}  {}\n", a, kernels, b, variant, c, d);
    };
    print("kernel", "variant", "time ratio", "best");
    for (const TuneRow& row : rows)
        print(row.kernels, row.variant, std::isfinite(row.ratio) ? fmt::format("{:.2f}", row.ratio) : "-", outcome(row));
}

void print_profile(const DeviceProfile& profile) {
    std::cout << fmt::format("\npackets of {}, {} packets per work-item, groups of {}", profile.packet_width, profile.block, profile.group);
    if (profile.atlas_image) std::cout << ", radiance maps as images";
    for (const auto& [kernel, group] : profile.groups) std::cout << fmt::format(", {} {}", kernel, group);
    std::cout << fmt::format("; costs of maps {:.2g}, {:.2g}, {:.2g}\n", profile.map_costs[0], profile.map_costs[1], profile.map_costs[2]);
}

Tuned search(const TuneCommand& command, const std::shared_ptr<Device>& device) {
    const auto say = [&](const std::string& stage) { log_info("tuning: " + stage); };
    const auto go_on = [] {
        if (interrupted_by() != 0) throw TuneStopped();
    };
    TuneRules rules{command.rounds, image_limits(*device).layers > 0, {}, say};
    if (device->profile().tuned) rules.stored = device->profile();
    TuningWork work(device, [](const std::string&, double) { return interrupted_by() == 0; });
    say("size of the work");
    work.fit(generic_profile(device->info()));
    Tuned tuned = tune_launches([&](const DeviceProfile& profile) { return work.run(profile); }, device->info(), rules);
    say("ways to make geometry maps");
    device->set_profile(tuned.profile);
    tuned.profile.map_costs = choose_costs(measure_maps(device, command.rounds, go_on), static_cast<int>(device->info().compute_units),
                                           rules.stored.value_or(DeviceProfile()).map_costs, tuned.rows);
    return tuned;
}

}  // namespace

ExitCode run_tune(const TuneCommand& command) {
    set_quiet(command.quiet);
    profile_folder();  // before minutes of measuring
    const std::shared_ptr<Device> device = Device::open(command.device);
    try {
        const Tuned tuned = search(command, device);
        print_rows(tuned.rows);
        print_profile(tuned.profile);
        const std::string file = printable(write_profile(device->info(), tuned.profile).string());
        std::cout << "wrote    " << file << "\n";
    } catch (const TuneStopped&) {
        print_error("interrupted; what renders use is as it was");
        return ExitCode::interrupted;
    }
    return ExitCode::ok;
}

}  // namespace pencil
