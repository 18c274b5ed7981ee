// `pencil stress`: small scenes that are stiff or extreme, what must come out, and what does: as text, as JSON, or as the table of
// docs/stability.md. The keys of the JSON are a contract: `schema` counts incompatible changes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/message.h"
#include "options/layer.h"
#include "options/option_values.h"
#include "stress/run_stress.h"
#include "stress/stress_cases.h"
#include "util/error.h"

namespace pencil {
namespace {

using Json = nlohmann::ordered_json;

constexpr int stress_schema = 2;

/// Those asked for by name, or all quick ones, or all.
std::vector<StressCase> chosen(const StressCommand& command) {
    std::vector<StressCase> rows;
    std::vector<std::string> names;
    for (StressCase& row : stress_cases()) {
        names.push_back(row.name);
        if (command.cases.empty() ? row.quick || command.all : has_group(command.cases, row.name)) rows.push_back(std::move(row));
    }
    for (const std::string& name : command.cases)
        if (!has_group(names, name)) throw UsageError(fmt::format("no stress case \"{}\"; there are {}", name, join(names)));
    return rows;
}

std::string interval_text(const Measurement& m) {
    if (m.low == 0 && m.high == 0) return "0";
    if (m.low == m.high) return fmt::format("{:.6g}", m.low);
    return m.low == 0 ? fmt::format("at most {:.6g}", m.high) : fmt::format("{:.6g} to {:.6g}", m.low, m.high);
}

void print_text(const StressResult& result) {
    std::cout << fmt::format("{:<13} {}: {}\n", to_string(result.verdict), result.row.name, result.row.scene);
    for (const Measurement& m : result.measured)
        std::cout << fmt::format("{:>13} {} {:.6g}, expected {}\n", m.holds() ? "" : "not", m.what, m.value, interval_text(m));
    if (!result.error.empty()) std::cout << fmt::format("{:>13} ended by: {}\n", "", result.error);
    std::cout.flush();
}

/// A row of the table: measurements one after the other, without the time where it is kept.
void print_markdown(const StressResult& result) {
    std::string expected, measured;
    for (const Measurement& m : result.measured) {
        if (m.what == "seconds" && m.holds()) continue;
        expected += fmt::format("{}{}: {}", expected.empty() ? "" : "; ", m.what, interval_text(m));
        measured += fmt::format("{}{:.4g}", measured.empty() ? "" : "; ", m.value);
    }
    if (!result.error.empty()) measured += " (" + result.error + ")";
    std::cout << fmt::format("| `{}` | {} | {} | {} | {:.1f} | {} |\n", result.row.name, result.row.scene, expected, measured,
                             result.seconds, to_string(result.verdict));
    std::cout.flush();
}

Json result_json(const StressResult& result) {
    Json measured = Json::array();
    for (const Measurement& m : result.measured)
        measured.push_back({{"what", m.what}, {"value", m.value}, {"low", m.low}, {"high", m.high}, {"holds", m.holds()}});
    return {{"name", result.row.name}, {"scene", result.row.scene}, {"measured", measured},
            {"error", result.error},   {"seconds", result.seconds}, {"verdict", to_string(result.verdict)}};
}

void print_json(const std::vector<StressResult>& results, const Device& device) {
    Json rows = Json::array();
    for (const StressResult& r : results) rows.push_back(result_json(r));
    const Json json{{"schema", stress_schema}, {"version", PENCIL_VERSION}, {"device", device.info().name}, {"cases", rows}};
    std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
}

void print_table_head() { std::cout << "| case | scene | expected | measured | s | verdict |\n|---|---|---|---|---|---|\n"; }

/// Runs until the end or an interruption, and prints what is to be printed after each case. Only what is finished.
std::vector<StressResult> run_all(const StressCommand& command, const std::vector<StressCase>& rows,
                                  const std::shared_ptr<Device>& device) {
    const auto go_on = [](const std::string&, double) { return interrupted_by() == 0; };
    std::vector<StressResult> results;
    for (const StressCase& row : rows) {
        if (interrupted_by() != 0) break;
        StressResult result = run_case(row, device, go_on);
        if (result.stopped) break;
        results.push_back(std::move(result));
        if (command.markdown) print_markdown(results.back());
        if (!command.json && !command.markdown) print_text(results.back());
    }
    return results;
}

}  // namespace

ExitCode run_stress(const StressCommand& command) {
    const std::vector<StressCase> rows = chosen(command);
    const std::shared_ptr<Device> device = Device::open(command.device);
    if (command.markdown) print_table_head();
    const std::vector<StressResult> results = run_all(command, rows, device);
    const std::ptrdiff_t failed =
        std::count_if(results.begin(), results.end(), [](const StressResult& r) { return r.verdict == Verdict::fails; });
    if (command.json) print_json(results, *device);
    if (!command.json && !command.markdown)
        std::cout << fmt::format("{} cases hold, {} fail\n", results.size() - static_cast<std::size_t>(failed), failed);
    if (results.size() < rows.size()) {
        print_error(fmt::format("interrupted after {} of {} cases", results.size(), rows.size()));
        return ExitCode::interrupted;
    }
    return failed > 0 ? ExitCode::not_held : ExitCode::ok;
}

}  // namespace pencil
