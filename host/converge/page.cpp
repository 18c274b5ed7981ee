// The page: one file, no scripts, no other resources, readable on light and dark screens.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "converge/embedded_text.h"
#include "converge/page_pictures.h"
#include "converge/page_tables.h"
#include "converge/pictures.h"
#include "converge/report.h"
#include "converge/text.h"

namespace pencil {
namespace {

std::string read_text(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string plot(const Report& report, const ErrorMetric& metric) {
    const std::filesystem::path folder = report.options.folder / "plots";
    const std::string light = data_uri("image/svg+xml", read_text(folder / (std::string(metric.key) + "-light.svg")));
    const std::string dark = data_uri("image/svg+xml", read_text(folder / (std::string(metric.key) + "-dark.svg")));
    return "<picture><source media=\"(prefers-color-scheme: dark)\" srcset=\"" + dark + "\"><img class=\"plot\" src=\"" + light +
           "\" alt=\"" + metric.title + " against time\"></picture>\n";
}

std::string section(const std::string& title, const std::string& caption, const std::string& content) {
    return "<section>\n<h2>" + title + "</h2>\n<p>" + caption + "</p>\n" + content + "</section>\n";
}

std::string list(const std::vector<std::string>& items, const std::string& css) {
    std::string html = "<ul class=\"" + css + "\">\n";
    for (const std::string& item : items) {
        html += "<li>" + html_text(item) + "</li>\n";
    }
    return items.empty() ? "" : html + "</ul>\n";
}

std::string header(const Report& report) {
    const ConvergeOptions& options = report.options;
    return "<header>\n<h1>Error against run time: " + html_text(options.scene.filename().string()) + "</h1>\n<p>" +
           std::to_string(options.width) + "×" + std::to_string(options.height) + " pixels, " + std::to_string(options.seeds) +
           " seeds per point. Pencil methods run on " + html_text(report.device.name) + "; the path tracer uses " +
           std::to_string(report.host_threads) + " CPU threads. pencil " + html_text(options.version) + ".</p>\n" +
           (report.finished ? ""
                            : "<p class=\"unfinished\">Unfinished: the measurement was interrupted after " +
                                  std::to_string(report.points.size()) + " runs. The same command goes on.</p>\n") +
           "</header>\n";
}

std::string plots(const Report& report, const std::string& missing) {
    if (!missing.empty()) {
        return list({missing}, "warnings");
    }
    std::string html = plot(report, error_metrics().front());
    html += "<div class=\"two\">\n";
    for (std::size_t i = 1; i < error_metrics().size(); ++i) {
        html += "<div>" + plot(report, error_metrics()[i]) + "</div>\n";
    }
    return html + "</div>\n";
}

std::string definitions(const Report& report) {
    const std::optional<double>& noise = report.truth.noise_rel_mse;
    std::string html = "<dl>\n";
    for (std::size_t i = 0; i < report.methods.size(); ++i) {
        html += "<dt>" + method_label(report, i) + "</dt><dd>" + html_text(report.methods[i].summary) + ".</dd>\n";
    }
    return html +
           "<dt>relative error</dt><dd>sqrt(relMSE), relMSE = mean((x − r)² / (r² + 0.01 m²)): x the image, r the reference, m = mean(r); "
           "over pixels and channels. The reference's own noise, where it is known, is taken off.</dd>\n"
           "<dt>RMSE</dt><dd>sqrt(mean((x − r)²)). Bright pixels decide it.</dd>\n"
           "<dt>L*a*b* RMS</dt><dd>root mean square distance of the displayed colours in CIE L*a*b* (D65), exposure " +
           round_text(report.truth.exposure) +
           "; a distance of about 2 is just visible.</dd>\n"
           "<dt>time</dt><dd>wall clock of a whole render or trace after the scene is loaded, without building kernels; the median of the "
           "seeds. Errors are root mean squares over the seeds; small dots in the plots are single runs.</dd>\n"
           "<dt>at equal time, at equal error</dt><dd>read off the curves by straight lines between points on logarithmic scales, never "
           "outside the measured range.</dd>\n"
           "<dt>slope, floor</dt><dd>error = c · time^slope by least squares; −0.5 is Monte Carlo. A floor f is named if error² = f² + "
           "(c · time^−s)² explains the points significantly better and f is at least half of the last error.</dd>\n"
           "<dt>bias, noise</dt><dd>parts of the relative error that all seeds share, and that averaging over seeds removes.</dd>\n"
           "<dt>reference</dt><dd>" +
           html_text(report.truth.name) + ", " + html_text(report.truth.origin) + ". " +
           (noise ? "Its own noise is about relMSE " + round_text(*noise) + " (" + percent_text(std::sqrt(*noise)) + ")."
                  : "Its own noise is not known.") +
           "</dd>\n</dl>\n";
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

}  // namespace

std::string page_html(const Report& report, const std::string& plots_missing) {
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<meta name=\"color-scheme\" content=\"light dark\">\n"
        "<title>Error against run time: " +
        html_text(report.options.scene.filename().string()) + "</title>\n<style>\n" + page_css + "</style>\n</head>\n<body>\n<main>\n";
    html += header(report);
    html += report.methods.empty() ? "<p>No run is finished yet.</p>\n" : verdict_cards(report);
    html += list(report.warnings, "warnings");
    if (!report.methods.empty()) {
        html +=
            section("Error against time",
                    "Both axes are logarithmic; lower and further left is better. The dashed grey curve is the path tracer, the baseline.",
                    plots(report, plots_missing));
        html += section("Error at equal time", "Below each error: how large it is next to the path tracer's. Best of a row in bold.",
                        equal_time_tables(report));
        html += section("Time to equal error", "Best of a row in bold. “Not reached” is not an estimate: the method was not run longer.",
                        equal_error_table(report));
        html += section("How the curves fall",
                        "Slopes and floors of the whole curves; bias, noise and mean(x) / mean(r) of the longest runs.", fit_table(report));
        html += section("Time per stage",
                        "Wall clock of the longest runs. Bars are shares of the run. Building the kernels took " +
                            mean_build_seconds(report) + " more per run on average, from the driver's cache after the first.",
                        stage_table(report));
        html += section("Images", "", picture_sections(report));
    }
    html += section("What the words mean", "", definitions(report));
    html += section("Again", "The numbers are in points.csv (one row per run) and summary.json beside this page.",
                    "<pre>" + html_text(report.options.command) + "</pre>\n");
    return html + "</main>\n</body>\n</html>\n";
}

}  // namespace pencil
