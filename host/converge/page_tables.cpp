#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "converge/page_data.h"
#include "converge/text.h"

namespace pencil {
namespace {

/// `kind`: how it looks, see page.css; `note`: a second, smaller line.
PageData cell(const std::string& text, const std::string& note = "", const std::string& kind = "") {
    return PageObject{{"text", text}, {"note", if_any(note)}, {"kind", if_any(kind)}};
}

/// Metrics by which another method is clearly ahead of the card's.
PageList objections(const Report& report, const Verdict& verdict) {
    PageList list;
    for (std::size_t i = 1; i < error_metrics().size(); ++i) {
        const ErrorMetric& metric = error_metrics()[i];
        const Verdict other = judge(curves_of(report, metric), verdict.seconds);
        if (other.ahead < 0) {
            continue;
        }
        const auto winner = static_cast<std::size_t>(other.ahead), ours = static_cast<std::size_t>(verdict.ahead);
        const double lead = other.errors[ours].value / other.errors[winner].value;
        if (lead >= level) {
            list.emplace_back(PageObject{{"metric", metric.title}, {"other", report.methods[winner].name}, {"lead", round_text(lead)}});
        }
    }
    return list;
}

PageData card(const Report& report, const Verdict& verdict) {
    const bool nobody = verdict.ahead < 0;
    const auto index = static_cast<std::size_t>(std::max(verdict.ahead, 0));
    PageObject card{{"time", seconds_text(verdict.seconds)}, {"nobody", nobody}, {"winner", !nobody}};
    if (nobody) {
        card["colour"] = "var(--line)";
        return card;
    }
    card.merge(method_data(report, index));
    card["error"] = percent_text(verdict.errors[index].value);
    card["alone"] = verdict.second < 0;
    if (verdict.second >= 0) {
        const auto second = static_cast<std::size_t>(verdict.second);
        const std::string other = fmt::format("{} ({})", report.methods[second].name, percent_text(verdict.errors[second].value));
        card[verdict.lead < level ? "level_with" : "ahead_of"] = other;
        card["lead"] = round_text(verdict.lead);
        card["objections"] = objections(report, verdict);
    }
    return card;
}

PageData error_cell(const ErrorMetric& metric, const Verdict& verdict, std::size_t index) {
    const Reading& reading = verdict.errors[index];
    if (reading.kind == Reading::Kind::before_first) {
        return cell("no image yet", "first after " + seconds_text(reading.value), "none");
    }
    if (reading.kind == Reading::Kind::not_reached) {
        return cell("not measured", "ends at " + seconds_text(reading.value), "none");
    }
    const Reading& base = verdict.errors.front();
    const bool comparable = index > 0 && base.kind == Reading::Kind::measured;
    return cell(value_text(metric, reading.value), comparable ? factor_text(reading.value / base.value) + " the path tracer's" : "",
                static_cast<int>(index) == verdict.ahead ? "best" : "");
}

PageData time_cell(const TimesToError& row, std::size_t index, bool best) {
    const Reading& time = row.times[index];
    if (time.kind == Reading::Kind::not_reached) {
        return cell("not reached", "within " + seconds_text(time.value), "none");
    }
    if (time.kind == Reading::Kind::before_first) {
        return cell("≤ " + seconds_text(time.value), "below it from the first point on");
    }
    const double speedup = row.speedups[index];
    const std::string note = index == 0 || speedup == 0 ? ""
                             : speedup >= 1             ? factor_text(speedup) + " faster than path tracing"
                                                        : factor_text(1 / speedup) + " slower than path tracing";
    return cell(seconds_text(time.value), note, best ? "best" : "");
}

/// The fastest method, or -1 if it is not known: one has reached the error before its first point.
int fastest(const TimesToError& row) {
    int best = -1;
    for (std::size_t i = 0; i < row.times.size(); ++i) {
        if (row.times[i].kind == Reading::Kind::before_first) {
            return -1;
        }
        const bool measured = row.times[i].kind == Reading::Kind::measured;
        if (measured && (best < 0 || row.times[i].value < row.times[static_cast<std::size_t>(best)].value)) {
            best = static_cast<int>(i);
        }
    }
    return best;
}

std::string floor_text(const ErrorMetric& metric, const Curve& curve) {
    const std::optional<FloorFit> floor = fit_floor(curve);
    if (!floor) {
        return "too few points";
    }
    return floor->visible ? value_text(metric, floor->floor) : "none visible";
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

std::string method_colour(std::size_t index) {
    const std::array<const char*, 6> colours{"#0a84d6", "#e0701a", "#149f78", "#c05fa8", "#b08a00", "#7a6ff0"};  // as in plot.py
    return index == 0 ? "var(--base)" : colours[(index - 1) % colours.size()];
}

}  // namespace

PageObject method_data(const Report& report, std::size_t index) {
    return {{"name", report.methods[index].name}, {"colour", method_colour(index)}};
}

PageList verdict_cards(const Report& report) {
    const std::vector<NamedCurve> curves = curves_of(report, error_metrics().front());
    PageList cards;
    for (const double seconds : verdict_times) {
        cards.push_back(card(report, judge(curves, seconds)));
    }
    return cards;
}

PageList equal_time_tables(const Report& report) {
    PageList tables;
    for (const ErrorMetric& metric : error_metrics()) {
        const std::vector<NamedCurve> curves = curves_of(report, metric);
        PageList rows;
        for (const double seconds : verdict_times) {
            const Verdict verdict = judge(curves, seconds);
            PageList cells;
            for (std::size_t i = 0; i < curves.size(); ++i) {
                cells.push_back(error_cell(metric, verdict, i));
            }
            rows.emplace_back(PageObject{{"head", seconds_text(seconds)}, {"cells", cells}});
        }
        tables.emplace_back(PageObject{{"metric", metric.title}, {"rows", rows}});
    }
    return tables;
}

PageList equal_error_rows(const Report& report) {
    const std::vector<NamedCurve> curves = curves_of(report, error_metrics().front());
    PageList rows;
    for (const double error : round_errors(curves)) {
        const TimesToError times = times_to(curves, error);
        const int best = fastest(times);
        PageList cells;
        for (std::size_t i = 0; i < curves.size(); ++i) {
            cells.push_back(time_cell(times, i, static_cast<int>(i) == best));
        }
        rows.emplace_back(PageObject{{"head", percent_text(error)}, {"cells", cells}});
    }
    return rows;
}

PageList fit_rows(const Report& report) {
    PageList rows;
    for (std::size_t i = 0; i < report.methods.size(); ++i) {
        const MethodSummary& method = report.methods[i];
        const BudgetSummary& last = method.budgets.back();
        PageList cells;
        for (const ErrorMetric& metric : error_metrics()) {
            const Curve curve = curve_of(method, metric);
            const std::optional<PowerLaw> law = fit_power_law(curve);
            cells.push_back(cell(law ? round_text(law->slope) : "–"));
            cells.push_back(cell(floor_text(metric, curve)));
        }
        for (const std::optional<double>& part : {last.bias, last.noise}) {
            cells.push_back(cell(part ? percent_text(*part) : "–"));
        }
        cells.push_back(cell(round_text(last.mean_ratio)));
        cells.push_back(cell(seconds_text(last.seconds)));
        PageObject row = method_data(report, i);
        row["cells"] = cells;
        rows.emplace_back(row);
    }
    return rows;
}

PageList stage_rows(const Report& report) {
    PageList rows;
    for (const std::string& stage : stage_names(report)) {
        PageList bars;
        for (std::size_t i = 1; i < report.methods.size(); ++i) {
            const BudgetSummary& budget = report.methods[i].budgets.back();
            const double seconds = stage_seconds(budget, stage);
            PageObject bar = method_data(report, i);
            bar["share"] = seconds < 0 ? PageData(false) : PageData(fmt::format("{:f}", 100 * seconds / budget.seconds));
            bar["seconds"] = seconds_text(seconds);
            bars.emplace_back(bar);
        }
        rows.emplace_back(PageObject{{"stage", stage}, {"bars", bars}});
    }
    return rows;
}

}  // namespace pencil
