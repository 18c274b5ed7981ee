#include "tune/tune.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pencil {
namespace {

const std::string all_kernels = "all";
/// Kernels that work on blocks of packets.
const std::set<std::string> block_kernels{"light_surfels", "project_pencils", "test_visibility"};
/// What looks up radiance maps, and what makes images of them.
const std::set<std::string> atlas_kernels{"copy to image", "project_pencils"};
/// Kernels that take less of the time are not worth code of their own.
constexpr double least_share = 0.02;

std::string text(const std::set<std::string>& kernels) {
    return kernels.empty() ? all_kernels : fmt::format("{}", fmt::join(kernels, ", "));
}

/// How far two group sizes are apart, in doublings.
double steps(std::size_t a, std::size_t b) { return std::abs(std::log2(static_cast<double>(a) / static_cast<double>(b))); }

bool same_launches(const DeviceProfile& a, const DeviceProfile& b) {
    return a.packet_width == b.packet_width && a.block == b.block && a.group == b.group && a.groups == b.groups &&
           a.atlas_image == b.atlas_image;
}

/// Kernels whose code or launches differ: all (none named) unless it is the groups of some alone.
std::set<std::string> differing(const DeviceProfile& a, const DeviceProfile& b) {
    if (a.packet_width != b.packet_width || a.group != b.group) return {};
    std::set<std::string> kernels;
    if (a.block != b.block) kernels = block_kernels;
    if (a.atlas_image != b.atlas_image) kernels.insert(atlas_kernels.begin(), atlas_kernels.end());
    for (const auto* groups : {&a.groups, &b.groups})
        for (const auto& [kernel, size] : *groups)
            if (a.group_of(kernel) != b.group_of(kernel)) kernels.insert(kernel);
    return kernels;
}

class Search {
public:
    Search(const Workload& work, const DeviceInfo& info, const TuneRules& rules)
        : work_(work), info_(info), rules_(rules), generic_(generic_profile(info)), best_(generic_) {}

    Tuned run() {
        try_widths();
        try_blocks();
        try_atlas();
        try_groups();
        confirm();
        best_.tuned = true;
        return {best_, std::move(rows_)};
    }

private:
    std::vector<Trial> beside_best(const std::vector<DeviceProfile>& variants, const std::string& stage) {
        if (rules_.stage) rules_.stage(stage);
        std::vector<DeviceProfile> profiles{best_};
        for (const DeviceProfile& variant : variants)
            if (trouble_of(variant, info_).empty()) profiles.push_back(variant);
        return try_profiles(work_, profiles, rules_.rounds);
    }

    void add_row(const std::set<std::string>& kernels, const std::string& variant, const Trial& trial, double ratio, bool kept) {
        rows_.push_back({text(kernels), variant, ratio, kept ? "kept" : trial.refused});
    }

    /// The fastest of the trials becomes the best, if it wins over the first.
    void choose(const std::vector<Trial>& trials, const std::set<std::string>& kernels,
                const std::function<std::string(const DeviceProfile&)>& name) {
        std::size_t winner = 0;
        std::vector<double> ratios{1};
        for (std::size_t i = 1; i < trials.size(); ++i) {
            ratios.push_back(time_ratio(trials[i], trials[0], kernels));
            if (ratios[i] < 1 - win_margin && ratios[i] < ratios[winner]) winner = i;
        }
        for (std::size_t i = 1; i < trials.size(); ++i) add_row(kernels, name(trials[i].profile), trials[i], ratios[i], i == winner);
        best_ = trials[winner].profile;
    }

    void try_widths() {
        std::vector<DeviceProfile> variants;
        for (const int width : {1, 4, 8, 16}) {
            if (width == best_.packet_width || (!info_.is_cpu && width > 4)) continue;  // wide packets are what registers of CPUs are for
            DeviceProfile variant = best_;
            variant.packet_width = width;
            variant.block = info_.is_cpu ? generic_block(width) : best_.block;
            variants.push_back(variant);
        }
        choose(beside_best(variants, "packet widths"), {},
               [](const DeviceProfile& p) { return fmt::format("packets of {}", p.packet_width); });
    }

    void try_blocks() {
        std::vector<DeviceProfile> variants;
        for (const int block : {1, 2, 4, 8, 16}) {
            if (block == best_.block || (!info_.is_cpu && block > 4)) continue;
            DeviceProfile variant = best_;
            variant.block = block;
            variants.push_back(variant);
        }
        choose(beside_best(variants, "packets per work-item"), block_kernels,
               [](const DeviceProfile& p) { return fmt::format("{} packets per work-item", p.block); });
    }

    void try_atlas() {
        if (!rules_.images) return;
        DeviceProfile variant = best_;
        variant.atlas_image = !best_.atlas_image;
        choose(beside_best({variant}, "radiance maps"), atlas_kernels,
               [](const DeviceProfile& p) { return std::string(p.atlas_image ? "image" : "buffer"); });
    }

    /// One run with groups of some size measures it for every kernel.
    void try_groups() {
        std::vector<DeviceProfile> variants;
        for (std::size_t group = info_.is_cpu ? 1 : 32; group <= (info_.is_cpu ? 64U : 256U); group *= 2) {
            if (group == best_.group) continue;
            DeviceProfile variant = best_;
            variant.group = group;
            variants.push_back(variant);
        }
        const std::vector<Trial> trials = beside_best(variants, "work-group sizes");
        const KernelTimes first = trials[0].rounds.front();
        for (const auto& [kernel, seconds] : first)
            if (seconds >= least_share * sum_of(first, {})) choose_group(kernel, trials);
    }

    /// The nearest to the generic one of those that are about as fast as the fastest: noise does not decide between equals.
    void choose_group(const std::string& kernel, const std::vector<Trial>& trials) {
        std::vector<double> ratios;
        for (const Trial& trial : trials) ratios.push_back(time_ratio(trial, trials[0], {kernel}));
        const double fastest = *std::min_element(ratios.begin(), ratios.end());
        std::size_t winner = 0;
        for (std::size_t i = 1; i < trials.size(); ++i) {
            const bool fast = ratios[i] < 1 - win_margin && ratios[i] <= fastest + stay_margin;
            if (fast && (winner == 0 || steps(trials[i].profile.group, best_.group) < steps(trials[winner].profile.group, best_.group)))
                winner = i;
        }
        for (std::size_t i = 1; i < trials.size(); ++i)
            add_row({kernel}, fmt::format("groups of {}", trials[i].profile.group), trials[i], ratios[i], i == winner);
        if (winner > 0) best_.groups[kernel] = trials[winner].profile.group;
    }

    /// What was found one by one, all together, and what is stored, beside the generic profile.
    void confirm() {
        const DeviceProfile found = best_;
        const bool has_stored = rules_.stored && !same_launches(*rules_.stored, generic_);
        best_ = generic_;
        std::vector<DeviceProfile> candidates;
        if (!same_launches(found, generic_)) candidates.push_back(found);
        if (has_stored) candidates.push_back(*rules_.stored);
        if (candidates.empty()) return;
        const std::vector<Trial> trials = beside_best(candidates, "all together");
        const Trial *fresh = nullptr, *stored = nullptr;
        for (std::size_t i = 1; i < trials.size(); ++i)
            (same_launches(trials[i].profile, found) && !fresh && !same_launches(found, generic_) ? fresh : stored) = &trials[i];
        const auto wins = [&](const Trial* trial, const Trial& over, double margin) {
            return trial && time_ratio(*trial, over, differing(trial->profile, over.profile)) < 1 - margin;
        };
        const Trial* chosen = wins(stored, trials[0], stay_margin) ? stored : nullptr;
        if (chosen ? wins(fresh, *chosen, win_margin) : wins(fresh, trials[0], win_margin)) chosen = fresh;
        if (chosen) best_ = chosen->profile;
        for (const Trial* trial : {fresh, stored})
            if (trial)
                add_row({}, trial == fresh ? "all of these" : "as tuned before", *trial, time_ratio(*trial, trials[0]), trial == chosen);
    }

    const Workload& work_;
    const DeviceInfo& info_;
    const TuneRules& rules_;
    const DeviceProfile generic_;
    DeviceProfile best_;
    std::vector<TuneRow> rows_;
};

}  // namespace

Tuned tune_launches(const Workload& work, const DeviceInfo& info, const TuneRules& rules) { return Search(work, info, rules).run(); }

}  // namespace pencil
