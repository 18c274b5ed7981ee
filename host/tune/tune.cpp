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
    /// Trials of the best so far, of the same again, which tells the noise, and of variants.
    std::vector<Trial> beside_best(const std::vector<DeviceProfile>& variants, const std::string& stage, int rounds) {
        if (rules_.stage) rules_.stage(stage);
        std::vector<DeviceProfile> profiles{best_, best_};
        for (const DeviceProfile& variant : variants)
            if (trouble_of(variant, info_).empty()) profiles.push_back(variant);
        return try_profiles(work_, profiles, rounds);
    }

    void add_row(const std::set<std::string>& kernels, const std::string& variant, const Trial& trial, double ratio, bool kept) {
        rows_.push_back({text(kernels), variant, ratio, kept ? "kept" : trial.refused});
    }

    /// The fastest of the trials becomes the best, if it wins over the first.
    void choose(const std::vector<Trial>& trials, const std::set<std::string>& kernels,
                const std::function<std::string(const DeviceProfile&)>& name) {
        std::size_t winner = 0;
        std::vector<double> ratios{1, 1};
        for (std::size_t i = first_variant; i < trials.size(); ++i) {
            ratios.push_back(time_ratio(trials[i], trials[0], kernels));
            if (ratios[i] < 1 - margin(trials, kernels) && ratios[i] < ratios[winner]) winner = i;
        }
        for (std::size_t i = first_variant; i < trials.size(); ++i)
            add_row(kernels, name(trials[i].profile), trials[i], ratios[i], i == winner);
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
        choose(beside_best(variants, "packet widths", rules_.rounds), {},
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
        choose(beside_best(variants, "packets per work-item", rules_.rounds), block_kernels,
               [](const DeviceProfile& p) { return fmt::format("{} packets per work-item", p.block); });
    }

    void try_atlas() {
        if (!rules_.images) return;
        DeviceProfile variant = best_;
        variant.atlas_image = !best_.atlas_image;
        choose(beside_best({variant}, "radiance maps", rules_.rounds), atlas_kernels,
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
        const std::vector<Trial> trials = beside_best(variants, "work-group sizes", rules_.rounds);
        for (const std::string& kernel : heavy_kernels(trials[0])) choose_group(kernel, trials);
    }

    /// The nearest to the generic one of those that are about as fast as the fastest: noise does not decide between equals.
    void choose_group(const std::string& kernel, const std::vector<Trial>& trials) {
        if (trials.size() <= first_variant) return;
        std::vector<double> ratios;
        ratios.reserve(trials.size());
        for (const Trial& trial : trials) ratios.push_back(time_ratio(trial, trials[0], {kernel}));
        const double fastest = *std::min_element(ratios.begin() + first_variant, ratios.end());
        const double wins = 1 - std::max(margin(trials, {kernel}), typical_margin(trials));
        std::size_t winner = 0;
        for (std::size_t i = first_variant; i < trials.size(); ++i) {
            const bool fast = ratios[i] < wins && ratios[i] <= fastest + stay_margin;
            if (fast && (winner == 0 || steps(trials[i].profile.group, best_.group) < steps(trials[winner].profile.group, best_.group)))
                winner = i;
        }
        for (std::size_t i = first_variant; i < trials.size(); ++i)
            add_row({kernel}, fmt::format("groups of {}", trials[i].profile.group), trials[i], ratios[i], i == winner);
        if (winner > 0) best_.groups[kernel] = trials[winner].profile.group;
    }

    /// What was found one by one, all together, and what is stored, beside the generic profile, in twice as many rounds.
    void confirm() {
        const DeviceProfile found = best_;
        best_ = generic_;
        std::vector<DeviceProfile> candidates;
        if (!same_launches(found, generic_)) candidates.push_back(found);
        const bool has_found = !candidates.empty(), has_stored = rules_.stored && !same_launches(*rules_.stored, generic_);
        if (has_stored) candidates.push_back(*rules_.stored);
        if (candidates.empty()) return;
        std::vector<Trial> trials = beside_best(candidates, "all together", 2 * rules_.rounds);
        Trial* fresh = has_found ? &trials[first_variant] : nullptr;
        const Trial* stored = has_stored && trials.size() == first_variant + candidates.size() ? &trials.back() : nullptr;
        if (fresh) drop_groups(trials, *fresh);
        const auto ratio = [&](const Trial& trial, const Trial& over) {
            return same_launches(trial.profile, over.profile) ? 1 : time_ratio(trial, over, differing(trial.profile, over.profile));
        };
        const double noise = noise_between(trials[1], trials[0]);
        const Trial* chosen = stored && ratio(*stored, trials[0]) < std::min(1 - stay_margin + noise, 1.0) ? stored : nullptr;
        if (fresh && ratio(*fresh, chosen ? *chosen : trials[0]) < 1 - std::max(win_margin, 2 * noise)) chosen = fresh;
        if (chosen) best_ = chosen->profile;
        if (fresh) add_row({}, "all that is best above", *fresh, time_ratio(*fresh, trials[0]), fresh == chosen);
        if (stored) add_row({}, "as tuned before", *stored, time_ratio(*stored, trials[0]), stored == chosen);
    }

    /// Groups of single kernels that do not win once more are left out; nothing else depends on them.
    void drop_groups(const std::vector<Trial>& trials, Trial& fresh) {
        DeviceProfile plain = fresh.profile;
        plain.groups.clear();
        if (!same_launches(plain, generic_)) return;  // they were measured with another width, block or form of maps
        const double wins = 1 - typical_margin(trials);
        for (auto group = fresh.profile.groups.begin(); group != fresh.profile.groups.end();) {
            const double ratio = time_ratio(fresh, trials[0], {group->first});
            const bool stays = ratio < wins;
            if (!stays) rows_.push_back({group->first, fmt::format("groups of {}, again", group->second), ratio, fresh.refused});
            group = stays ? std::next(group) : fresh.profile.groups.erase(group);
        }
    }

    /// Kernels that are worth code of their own.
    static std::set<std::string> heavy_kernels(const Trial& trial) {
        std::set<std::string> kernels;
        const KernelTimes& first = trial.rounds.front();
        for (const auto& [kernel, seconds] : first)
            if (seconds >= least_share * sum_of(first, {})) kernels.insert(kernel);
        return kernels;
    }

    static double margin(const std::vector<Trial>& trials, const std::set<std::string>& kernels) {
        return std::max(win_margin, 2 * noise_between(trials[1], trials[0], kernels));
    }

    /// That of the kernel in the middle: one kernel may be quiet by chance.
    static double typical_margin(const std::vector<Trial>& trials) {
        std::vector<double> margins;
        for (const std::string& kernel : heavy_kernels(trials[0])) margins.push_back(margin(trials, {kernel}));
        std::sort(margins.begin(), margins.end());
        return margins.empty() ? win_margin : margins[margins.size() / 2];
    }

    static constexpr std::size_t first_variant = 2;  // among trials
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
