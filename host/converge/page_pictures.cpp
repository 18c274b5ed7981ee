#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "compare/difference_image.h"
#include "compare/image_layers.h"
#include "converge/page_data.h"
#include "converge/pictures.h"
#include "converge/runs.h"
#include "converge/text.h"

namespace pencil {
namespace {

constexpr double early_seconds = 1;

struct Shown {
    std::size_t method = 0;
    const BudgetSummary* budget = nullptr;
    std::vector<float> rgb, differences;
};

/// The image of the first seed; nothing if its file is gone.
std::vector<Shown> load(const Report& report, std::size_t method, const BudgetSummary& budget) {
    const std::filesystem::path file = image_file(report.options, report.methods[method].name, budget.budget, budget.seeds.front());
    if (!std::filesystem::exists(file)) return {};
    Shown shown{method, &budget, split_layers(read_image(file)).front().pixels, {}};
    if (shown.rgb.size() != report.truth.rgb.size()) return {};
    shown.differences = relative_difference(shown.rgb.data(), report.truth.rgb.data(), shown.rgb.size() / 3);
    return {std::move(shown)};
}

const BudgetSummary& closest(const MethodSummary& method, double seconds) {
    const auto distance = [&](const BudgetSummary& budget) { return std::abs(std::log(budget.seconds / seconds)); };
    return *std::min_element(method.budgets.begin(), method.budgets.end(),
                             [&](const BudgetSummary& a, const BudgetSummary& b) { return distance(a) < distance(b); });
}

PageObject pair_of(const Report& report, const Shown& shown, double scale) {
    const Truth& truth = report.truth;
    PageObject pair = method_data(report, shown.method);
    pair["time"] = seconds_text(shown.budget->seconds);
    pair["error"] = percent_text(shown.budget->relative_error);
    pair["image"] = picture_uri(shown.rgb, truth.width, truth.height, truth.exposure);
    pair["difference"] = picture_uri(false_colour(shown.differences, scale), truth.width, truth.height, 1);
    return pair;
}

/// The reference and what is compared with it.
PageObject row(const Report& report, const std::string& title, const std::vector<Shown>& all, double scale) {
    const Truth& truth = report.truth;
    PageList pairs;
    for (const Shown& shown : all) pairs.emplace_back(pair_of(report, shown, scale));
    return {{"title", title}, {"reference_image", picture_uri(truth.rgb, truth.width, truth.height, truth.exposure)}, {"pairs", pairs}};
}

}  // namespace

PagePictures pictures_of(const Report& report) {
    std::vector<Shown> early, late;
    for (std::size_t i = 0; i < report.methods.size(); ++i) {
        for (auto [list, budget] :
             {std::pair(&early, &closest(report.methods[i], early_seconds)), std::pair(&late, &report.methods[i].budgets.back())}) {
            std::vector<Shown> loaded = load(report, i, *budget);
            std::move(loaded.begin(), loaded.end(), std::back_inserter(*list));
        }
    }
    double scale = 0;
    for (const Shown& shown : late) scale = std::max(scale, difference_scale(shown.differences));
    scale = scale > 0 ? scale : 1;
    return {{row(report, "At about " + seconds_text(early_seconds), early, scale), row(report, "At the longest time", late, scale)}, scale};
}

}  // namespace pencil
