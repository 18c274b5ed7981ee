#include "converge/identity.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "converge/methods.h"
#include "converge/runs.h"
#include "util/error.h"
#include "util/output_file.h"

namespace pencil {
namespace {

using Json = nlohmann::ordered_json;

const char* const file_name = "run.json";
const char* const advice = "; use another folder, or delete this one to measure again";

Json read_identity(const std::filesystem::path& file) {
    std::ifstream stream(file);
    return stream ? Json::parse(stream, nullptr, false) : Json();
}

bool is_known(const std::string& method) {
    const std::vector<MeasuredMethod>& methods = all_methods();
    return method == path_tracer_name ||
           std::any_of(methods.begin(), methods.end(), [&](const MeasuredMethod& known) { return known.name == method; });
}

}  // namespace

void check_identity(const std::filesystem::path& folder, const Identity& identity, const std::vector<RunPoint>& points) {
    const Json old = read_identity(folder / file_name);
    if (!old.is_object()) {
        if (!points.empty()) {
            throw UsageError(fmt::format("{} holds runs, but no readable run.json that says of what{}", folder.string(), advice));
        }
        return;
    }
    for (const auto& [key, value] : identity) {
        if (!points.empty() && old.contains(key) && old[key] != Json(value)) {
            throw UsageError(
                fmt::format("{} holds runs with another {}: {} there, \"{}\" now{}", folder.string(), key, old[key].dump(), value, advice));
        }
    }
    const auto changed = [](const RunPoint& point) {
        return is_known(point.method) && run_flags(point.method, point.budget) != point.options;
    };
    const auto point = std::find_if(points.begin(), points.end(), changed);
    if (point != points.end()) {
        throw UsageError(fmt::format("{} holds runs of {} with other options: \"{}\" there, \"{}\" now{}", folder.string(), point->method,
                                     point->options, run_flags(point->method, point->budget), advice));
    }
}

void write_identity(const std::filesystem::path& folder, const Identity& identity) {
    const std::string text = Json(identity).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    write_file(folder / file_name, text.data(), text.size());
}

}  // namespace pencil
