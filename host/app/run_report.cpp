// The report in words, and the image's metadata.
#include "app/run_report.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>
#include <iomanip>
#include <ostream>

#include "app/message.h"
#include "app/option_report.h"
#include "options/option_values.h"
#include "options/render_option_table.h"
#include "util/format.h"

namespace pencil {
namespace {

constexpr int name_width = 28, number_width = 12;  // [characters]

void print_stage(std::ostream& out, const StageTime& stage) {
    out << std::left << std::setw(name_width) << printable(stage.name) << std::right << std::fixed << std::setprecision(3)
        << std::setw(number_width) << stage.wall_seconds;
    if (stage.launches > 0)
        out << std::setw(number_width) << stage.device_seconds << std::setw(number_width) << stage.launches;
    else
        out << std::setw(number_width) << "-" << std::setw(number_width) << "-";
    out << "\n";
}

std::string device_line(const DeviceInfo& device) { return printable(device.name + " (" + device.platform + "), driver " + device.driver); }

std::string checked(const CertifiedError& certified) {
    if (certified.points < 2) return " estimated";
    const double reach = interval_errors * certified.standard_error;
    return fmt::format(" estimated; by light paths to {} pixels {} to {}, mean {:+.2f} % +- {:.2f} %", certified.points,
                       format_short(std::max(certified.relmse - reach, 0.0)), format_short(certified.relmse + reach),
                       100 * certified.mean_bias, 100 * interval_errors * certified.mean_error);
}

/// What share of the film's pencils each device took, where several did.
std::string share_line(const std::map<std::string, std::uint64_t>& pencils) {
    double sum = 0;
    for (const auto& [device, count] : pencils) sum += static_cast<double>(count);
    std::string line;
    for (const auto& [device, count] : pencils)
        line += fmt::format("{}{} {:.0f} %", line.empty() ? "\nshares   " : ", ", device,
                            100 * static_cast<double>(count) / std::max(sum, 1.0));
    return line;
}

std::string bounce_line(const RenderStats& stats) {
    if (stats.passes > 0) {
        const bool known = std::isfinite(stats.estimated_error);
        return fmt::format("to the end, residual {}\npasses   {}, pencils: {} in the world, {} for the film{}\nerror    {}",
                           format_short(stats.residual), stats.passes, stats.world_pencils, stats.film_pencils,
                           share_line(stats.device_pencils),
                           known ? "relMSE " + format_short(stats.estimated_error) + checked(stats.certified) : "unknown");
    }
    std::string line = fmt::format("{}, residual {}", stats.bounces.size(), format_short(stats.residual));
    line += stats.tail_closed ? ", added as a geometric tail" : "";
    if (stats.certified.points > 1) line += "\nerror    relMSE " + format_short(stats.estimated_error) + checked(stats.certified);
    return line;
}

}  // namespace

std::uint64_t peak_resident_bytes() {
    struct rusage usage {};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

void print_summary(std::ostream& out, const RunReport& report, const std::vector<std::filesystem::path>& written) {
    out << std::left << std::setw(name_width) << "stage" << std::right << std::setw(number_width) << "wall s" << std::setw(number_width)
        << "device s" << std::setw(number_width) << "launches"
        << "\n";
    StageTime total{"total", report.total_wall_seconds, 0, 0, {}};
    for (const StageTime& stage : report.stages) {
        print_stage(out, stage);
        total.device_seconds += stage.device_seconds;
        total.launches += stage.launches;
    }
    print_stage(out, total);
    out << "\ndevice   " << device_line(report.device) << "\nmemory   " << format_size(peak_resident_bytes()) << " resident at most, "
        << format_size(report.stats.device_peak_bytes) << " in device buffers\nimage    " << report.width << "x" << report.height << ", "
        << report.stats.triangles << " triangles, " << report.stats.film_surfels << " film surfels";
    if (report.stats.blind_surfels > 0) out << ", " << report.stats.blind_surfels << " of them seen by no pencil of the first set";
    out << "\nbounces  " << bounce_line(report.stats) << "\n";
    for (const std::filesystem::path& file : written) out << "wrote    " << printable(file.string()) << "\n";
}

void print_explanation(std::ostream& out, const RunReport& report) {
    out << "device: " << device_line(report.device) << "\n";
    for (const std::string& sentence : report.stats.explain) out << printable(sentence) << "\n";
    out << "layers written: beauty" << (report.layers.empty() ? "" : ", ") << join(report.layers) << "\n";
}

Metadata image_metadata(const RunReport& report, const RenderCommand& command, bool times) {
    Metadata metadata{
        {"Software", "pencil " PENCIL_VERSION},
        {"pencil:version", PENCIL_VERSION},
        {"pencil:scene", command.scene.filename().string()},
        {"pencil:sceneFingerprint", report.scene_fingerprint},
        {"pencil:device", report.device.name},
        {"pencil:driver", report.device.platform + " " + report.device.driver},
        {"pencil:packetWidth", report.profile.packet_width},  // the order of float additions depends on it
    };
    RenderOptions options = report.options;
    add_options(metadata, render_option_table(options));
    for (const auto& [name, value] : command.load.defines) metadata["pencil:define:" + name] = value;
    if (report.interrupted) metadata["pencil:interrupted"] = 1;
    if (times) {
        metadata["pencil:wallSeconds"] = report.total_wall_seconds;
        metadata["pencil:kernelBuildSeconds"] = report.kernel_build_seconds;
    }
    return metadata;
}

}  // namespace pencil
