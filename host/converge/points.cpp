#include "converge/points.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "converge/run_fields.h"
#include "util/error.h"

namespace pencil {
namespace {

namespace fs = std::filesystem;

using Json = nlohmann::ordered_json;

/// JSON has no infinite numbers: "inf", "nan".
Json number_json(double value) { return std::isfinite(value) ? Json(value) : Json(fmt::to_string(value)); }

double number_of(const Json& json) { return json.is_string() ? std::stod(json.get<std::string>()) : json.get<double>(); }

std::string run_line(const RunPoint& point) {
    Json json{{"method", point.method}, {"budget", point.budget}, {"seed", point.seed}};
    for (const RunField& field : run_fields) json[field.key] = number_json(point.*field.value);
    json["excluded_pixels"] = point.excluded_pixels;
    json["load"] = number_json(point.load);
    json["options"] = point.options;
    json["stages"] = Json::object();
    for (const auto& [name, seconds] : point.stages) json["stages"][name] = number_json(seconds);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// Json::exception or std::invalid_argument if it is no run.
RunPoint parse_run(const std::string& line) {
    const Json json = Json::parse(line);
    RunPoint point;
    json.at("method").get_to(point.method);
    json.at("budget").get_to(point.budget);
    json.at("seed").get_to(point.seed);
    for (const RunField& field : run_fields) point.*field.value = number_of(json.at(field.key));
    json.at("excluded_pixels").get_to(point.excluded_pixels);
    point.load = number_of(json.at("load"));
    json.at("options").get_to(point.options);
    for (const auto& [name, seconds] : json.at("stages").items()) point.stages.emplace_back(name, number_of(seconds));
    return point;
}

std::string read_text(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Bytes of the lines that are whole.
std::size_t whole_lines(const std::string& text) { return text.rfind('\n') + 1; }

[[noreturn]] void cannot_write(const fs::path& file) {
    throw OutputError(fmt::format("cannot write {}: {}", file.string(), std::strerror(errno)));
}

}  // namespace

RunLog read_runs(const fs::path& file) {
    const std::string text = read_text(file);
    const std::size_t whole = whole_lines(text);
    RunLog log;
    for (std::size_t start = 0; start < whole;) {
        const std::size_t end = text.find('\n', start);
        try {
            log.points.push_back(parse_run(text.substr(start, end - start)));
        } catch (const std::exception&) {
            throw OutputError(fmt::format("{}:{}: not a run of this version; use another folder, or delete this one to measure again",
                                          file.string(), log.points.size() + 1));
        }
        start = end + 1;
    }
    if (whole < text.size())
        log.warning = fmt::format("{}:{}: the line was cut off; its run is measured again", file.string(), log.points.size() + 1);
    return log;
}

void append_run(const fs::path& file, const RunPoint& point) {
    const std::string before = read_text(file), line = run_line(point);
    errno = 0;
    if (whole_lines(before) < before.size() && ::truncate(file.c_str(), static_cast<off_t>(whole_lines(before))) != 0) cannot_write(file);
    std::ofstream stream(file, std::ios::binary | std::ios::app);
    stream.write(line.data(), static_cast<std::streamsize>(line.size()));
    stream.close();
    if (!stream) cannot_write(file);
}

}  // namespace pencil
