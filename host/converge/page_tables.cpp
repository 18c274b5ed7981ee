#include "converge/page_tables.h"

#include <algorithm>
#include <array>

#include "converge/text.h"

namespace pencil {
namespace {

std::string value_text(const ErrorMetric& metric, double value) { return metric.percent ? percent_text(value) : round_text(value); }

std::string cell(const std::string& content, const std::string& css = "") {
    return "<td" + (css.empty() ? std::string() : " class=\"" + css + "\"") + ">" + content + "</td>";
}

/// The first column says what the row is, the others belong to the methods.
std::string head_row(const Report& report, const std::string& first) {
    std::string row = "<tr><th>" + first + "</th>";
    for (std::size_t i = 0; i < report.methods.size(); ++i) {
        row += "<th>" + method_label(report, i) + "</th>";
    }
    return row + "</tr>\n";
}

std::string table(const std::string& rows) { return "<div class=\"wide\"><table>\n" + rows + "</table></div>\n"; }

/// Metrics by which another method is clearly ahead of the card's.
std::string disagreement(const Report& report, const Verdict& verdict) {
    std::string text;
    for (std::size_t i = 1; i < error_metrics().size(); ++i) {
        const ErrorMetric& metric = error_metrics()[i];
        const Verdict other = judge(curves_of(report, metric), verdict.seconds);
        if (other.ahead < 0) {
            continue;
        }
        const auto winner = static_cast<std::size_t>(other.ahead), ours = static_cast<std::size_t>(verdict.ahead);
        const double lead = other.errors[ours].value / other.errors[winner].value;
        if (lead >= level) {
            text += std::string("<small>by ") + metric.title + ", " + html_text(report.methods[winner].name) + " is ahead of it by " +
                    round_text(lead) + "</small>";
        }
    }
    return text;
}

std::string card(const Report& report, const Verdict& verdict) {
    const auto index = static_cast<std::size_t>(std::max(verdict.ahead, 0));
    std::string text = "<div class=\"card\" style=\"--method:" + (verdict.ahead < 0 ? "var(--line)" : method_colour(index)) +
                       "\"><div class=\"when\">after " + seconds_text(verdict.seconds) + "</div>\n";
    if (verdict.ahead < 0) {
        return text + "<div class=\"who\">nobody</div><div>no method is measured at this time</div></div>\n";
    }
    const std::string error = percent_text(verdict.errors[index].value);
    text += "<div class=\"who\">" + html_text(report.methods[index].name) + "</div><div class=\"what\"><b>" + error +
            "</b> relative error</div>\n";
    if (verdict.second < 0) {
        return text + "<div>the only one measured at this time</div></div>\n";
    }
    const auto second = static_cast<std::size_t>(verdict.second);
    const std::string other = html_text(report.methods[second].name) + " (" + percent_text(verdict.errors[second].value) + ")";
    return text + "<div>" +
           (verdict.lead < level ? "level with " + other
                                 : "ahead of " + other + " by a factor of <b>" + round_text(verdict.lead) + "</b>") +
           disagreement(report, verdict) + "</div></div>\n";
}

std::string error_cell(const ErrorMetric& metric, const Verdict& verdict, std::size_t index) {
    const Reading& reading = verdict.errors[index];
    if (reading.kind == Reading::Kind::before_first) {
        return cell("no image yet<small>first after " + seconds_text(reading.value) + "</small>", "none");
    }
    if (reading.kind == Reading::Kind::not_reached) {
        return cell("not measured<small>ends at " + seconds_text(reading.value) + "</small>", "none");
    }
    const Reading& base = verdict.errors.front();
    const bool comparable = index > 0 && base.kind == Reading::Kind::measured;
    const std::string ratio =
        comparable ? "<small>" + factor_text(reading.value / base.value) + " the path tracer's</small>" : std::string();
    return cell(value_text(metric, reading.value) + ratio, static_cast<int>(index) == verdict.ahead ? "best" : "");
}

std::string time_cell(const TimesToError& row, std::size_t index, bool best) {
    const Reading& time = row.times[index];
    if (time.kind == Reading::Kind::not_reached) {
        return cell("not reached<small>within " + seconds_text(time.value) + "</small>", "none");
    }
    if (time.kind == Reading::Kind::before_first) {
        return cell("&le; " + seconds_text(time.value) + "<small>below it from the first point on</small>");
    }
    const double speedup = row.speedups[index];
    const std::string note = index == 0 || speedup == 0 ? std::string()
                             : speedup >= 1             ? "<small>" + factor_text(speedup) + " faster than path tracing</small>"
                                                        : "<small>" + factor_text(1 / speedup) + " slower than path tracing</small>";
    return cell(seconds_text(time.value) + note, best ? "best" : "");
}

std::string equal_error_row(const std::vector<NamedCurve>& curves, double error) {
    const TimesToError row = times_to(curves, error);
    int best = -1;
    for (std::size_t i = 0; i < row.times.size(); ++i) {
        const bool measured = row.times[i].kind == Reading::Kind::measured;
        if (row.times[i].kind == Reading::Kind::before_first) {
            best = -1;
            break;  // reached before the first point: the fastest is not known
        }
        if (measured && (best < 0 || row.times[i].value < row.times[static_cast<std::size_t>(best)].value)) {
            best = static_cast<int>(i);
        }
    }
    std::string text = "<tr><th>" + percent_text(error) + "</th>";
    for (std::size_t i = 0; i < curves.size(); ++i) {
        text += time_cell(row, i, static_cast<int>(i) == best);
    }
    return text + "</tr>\n";
}

std::string floor_text(const ErrorMetric& metric, const Curve& curve) {
    const std::optional<FloorFit> floor = fit_floor(curve);
    if (!floor) {
        return "too few points";
    }
    return floor->visible ? value_text(metric, floor->floor) : "none visible";
}

std::string fit_row(const Report& report, std::size_t index) {
    const MethodSummary& method = report.methods[index];
    const BudgetSummary& last = method.budgets.back();
    std::string row = "<tr><th>" + method_label(report, index) + "</th>";
    for (const ErrorMetric& metric : error_metrics()) {
        const Curve curve = curve_of(method, metric);
        const std::optional<PowerLaw> law = fit_power_law(curve);
        row += cell(law ? round_text(law->slope) : "–") + cell(floor_text(metric, curve));
    }
    row += cell(last.bias ? percent_text(*last.bias) : "–") + cell(last.noise ? percent_text(*last.noise) : "–");
    return row + cell(round_text(last.mean_ratio)) + cell(seconds_text(last.seconds)) + "</tr>\n";
}

double stage_seconds(const BudgetSummary& budget, const std::string& stage) {
    for (const auto& [name, seconds] : budget.stages) {
        if (name == stage) {
            return seconds;
        }
    }
    return -1;
}

/// Stages of all pencil methods in the order of execution.
std::vector<std::string> stage_names(const Report& report) {
    std::vector<std::string> names;
    for (std::size_t i = 1; i < report.methods.size(); ++i) {
        for (const auto& [name, seconds] : report.methods[i].budgets.back().stages) {
            if (std::find(names.begin(), names.end(), name) == names.end()) {
                names.push_back(name);
            }
        }
    }
    return names;
}

}  // namespace

std::string method_colour(std::size_t index) {
    const std::array<const char*, 6> colours{"#0a84d6", "#e0701a", "#149f78", "#c05fa8", "#b08a00", "#7a6ff0"};  // as in plot.py
    return index == 0 ? "var(--base)" : colours[(index - 1) % colours.size()];
}

std::string method_label(const Report& report, std::size_t index) {
    return "<span class=\"dot\" style=\"background:" + method_colour(index) + "\"></span>" + html_text(report.methods[index].name);
}

std::string verdict_cards(const Report& report) {
    const std::vector<NamedCurve> curves = curves_of(report, error_metrics().front());
    std::string cards = "<div class=\"cards\">\n";
    for (const double seconds : verdict_times) {
        cards += card(report, judge(curves, seconds));
    }
    return cards + "</div>\n";
}

std::string equal_time_tables(const Report& report) {
    std::string rows = head_row(report, "error after");
    for (const ErrorMetric& metric : error_metrics()) {
        const std::vector<NamedCurve> curves = curves_of(report, metric);
        rows += "<tr><th class=\"group\" colspan=\"" + std::to_string(report.methods.size() + 1) + "\">" + metric.title + "</th></tr>\n";
        for (const double seconds : verdict_times) {
            const Verdict verdict = judge(curves, seconds);
            rows += "<tr><th>" + seconds_text(seconds) + "</th>";
            for (std::size_t i = 0; i < curves.size(); ++i) {
                rows += error_cell(metric, verdict, i);
            }
            rows += "</tr>\n";
        }
    }
    return table(rows);
}

std::string equal_error_table(const Report& report) {
    const std::vector<NamedCurve> curves = curves_of(report, error_metrics().front());
    std::string rows = head_row(report, "time to a relative error of");
    for (const double error : round_errors(curves)) {
        rows += equal_error_row(curves, error);
    }
    return table(rows);
}

std::string fit_table(const Report& report) {
    std::string groups = "<tr><th></th>", columns = "<tr><th>method</th>";
    for (const ErrorMetric& metric : error_metrics()) {
        groups += std::string("<th colspan=\"2\">") + metric.title + "</th>";
        columns += "<th>slope</th><th>floor</th>";
    }
    std::string rows = groups + "<th colspan=\"4\">at the longest time</th></tr>\n" + columns +
                       "<th>bias</th><th>noise</th><th>mean ratio</th><th>time</th></tr>\n";
    for (std::size_t i = 0; i < report.methods.size(); ++i) {
        rows += fit_row(report, i);
    }
    return table(rows);
}

std::string stage_table(const Report& report) {
    std::string rows = "<tr><th>stage</th>";
    for (std::size_t i = 1; i < report.methods.size(); ++i) {
        rows += "<th>" + method_label(report, i) + "<small>" + html_text(report.methods[i].budgets.back().options) + "</small></th>";
    }
    rows += "</tr>\n";
    for (const std::string& stage : stage_names(report)) {
        rows += "<tr><th>" + html_text(stage) + "</th>";
        for (std::size_t i = 1; i < report.methods.size(); ++i) {
            const BudgetSummary& budget = report.methods[i].budgets.back();
            const double seconds = stage_seconds(budget, stage);
            const std::string width = std::to_string(std::max(0.0, 100 * seconds / budget.seconds));
            rows += seconds < 0 ? cell("–", "none")
                                : "<td class=\"bar\" style=\"--share:" + width + "%;--method:" + method_colour(i) + "\">" +
                                      seconds_text(seconds) + "</td>";
        }
        rows += "</tr>\n";
    }
    return table(rows);
}

}  // namespace pencil
