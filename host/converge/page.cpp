// The page: one file, no scripts, no other resources, readable on light and dark screens. Its words are in page.html.mustache.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "converge/embedded_text.h"
#include "converge/page_data.h"
#include "converge/pictures.h"
#include "converge/report.h"
#include "converge/text.h"

namespace pencil {
namespace {

/// A part of the page that is used several times; without the end of its file's last line.
std::string partial(const std::string& text) { return text.substr(0, text.find_last_not_of('\n') + 1); }

std::string read_text(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

PageObject plot(const Report& report, const ErrorMetric& metric) {
    const auto uri = [&](const char* theme) {
        const std::filesystem::path file = report.options.folder / "plots" / fmt::format("{}-{}.svg", metric.key, theme);
        return data_uri("image/svg+xml", read_text(file));
    };
    return {{"light", uri("light")}, {"dark", uri("dark")}, {"metric", metric.title}};
}

std::string mean_build_seconds(const Report& report) {
    double sum = 0;
    int renders = 0;
    for (const RunPoint& point : report.points) {
        sum += point.build_seconds;
        renders += point.build_seconds > 0 ? 1 : 0;
    }
    return renders > 0 ? seconds_text(sum / renders) : "no time";
}

void add_run(PageData& page, const Report& report) {
    const ConvergeOptions& options = report.options;
    page["scene"] = options.scene.filename().string();
    page["width"] = fmt::to_string(options.width);
    page["height"] = fmt::to_string(options.height);
    page["seeds"] = fmt::to_string(options.seeds);
    page["device"] = report.device.name;
    page["threads"] = fmt::to_string(report.host_threads);
    page["version"] = options.version;
    page["command"] = options.command;
    page["unfinished"] = !report.finished;
    page["runs"] = fmt::to_string(report.points.size());
    page["has_warnings"] = !report.warnings.empty();
    page["warnings"] = PageList(report.warnings.begin(), report.warnings.end());
}

void add_truth(PageData& page, const Truth& truth) {
    page["reference"] = truth.name;
    page["origin"] = truth.origin;
    page["exposure"] = round_text(truth.exposure);
    page["noise"] = truth.noise_rel_mse ? PageData(round_text(*truth.noise_rel_mse)) : PageData(false);
    page["noise_error"] = percent_text(std::sqrt(truth.noise_rel_mse.value_or(0)));
}

void add_methods(PageData& page, const Report& report) {
    PageList methods, stage_methods, metrics;
    for (std::size_t i = 0; i < report.methods.size(); ++i) {
        PageObject method = method_data(report, i);
        method["summary"] = report.methods[i].summary;
        method["options"] = report.methods[i].budgets.back().options;
        methods.emplace_back(method);
        if (i > 0) stage_methods.emplace_back(method);
    }
    for (const ErrorMetric& metric : error_metrics()) metrics.emplace_back(metric.title);
    page["methods"] = methods;
    page["stage_methods"] = stage_methods;
    page["metrics"] = metrics;
    page["columns"] = fmt::to_string(report.methods.size() + 1);
}

void add_measurements(PageData& page, const Report& report, bool with_plots) {
    page["cards"] = verdict_cards(report);
    page["equal_time"] = equal_time_tables(report);
    page["equal_error"] = equal_error_rows(report);
    page["fits"] = fit_rows(report);
    page["stages"] = stage_rows(report);
    page["build_seconds"] = mean_build_seconds(report);
    const PagePictures pictures = pictures_of(report);
    page["picture_rows"] = pictures.rows;
    page["full_colour"] = percent_text(pictures.full_colour);
    PageList small_plots;
    for (std::size_t i = 1; with_plots && i < error_metrics().size(); ++i) small_plots.emplace_back(plot(report, error_metrics()[i]));
    page["large_plot"] = with_plots ? PageData(plot(report, error_metrics().front())) : PageData(false);
    page["small_plots"] = small_plots;
}

}  // namespace

std::string page_html(const Report& report, const std::string& plots_missing) {
    PageData page{PageObject{{"style", page_css},
                             {"method", partial(method_template)},
                             {"row", partial(row_template)},
                             {"plot", partial(plot_template)},
                             {"plots_missing", if_any(plots_missing)},
                             {"measured", !report.methods.empty()}}};
    add_run(page, report);
    add_truth(page, report.truth);
    add_methods(page, report);
    if (!report.methods.empty()) add_measurements(page, report, plots_missing.empty());
    kainjow::mustache::mustache html(page_template);
    std::string text = html.render(page);
    if (!html.is_valid()) throw std::logic_error("page.html.mustache: " + html.error_message());
    return text;
}

}  // namespace pencil
