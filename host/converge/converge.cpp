#include "converge/converge.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <thread>

#include "converge/identity.h"
#include "converge/methods.h"
#include "converge/plots.h"
#include "converge/runs.h"
#include "scene/scene_fingerprint.h"
#include "util/error.h"
#include "util/format.h"
#include "util/output_file.h"

namespace pencil {
namespace {

namespace fs = std::filesystem;

fs::path runs_file(const ConvergeOptions& options) { return options.folder / "runs.jsonl"; }
fs::path table_file(const ConvergeOptions& options) { return options.folder / "points.csv"; }

/// Finished runs. UsageError if an older version, which kept them in points.csv alone, has filled the folder.
RunLog finished_runs(const ConvergeOptions& options) {
    if (!fs::exists(runs_file(options)) && fs::exists(table_file(options))) {
        throw UsageError(
            fmt::format("{} holds points.csv without runs.jsonl: it was made by an older version of pencil, whose runs cannot "
                        "be continued; use another folder, or delete this one to measure again",
                        options.folder.string()));
    }
    return read_runs(runs_file(options));
}

Identity identity_of(const Scene& scene, const ConvergeOptions& options, const DeviceInfo& device) {
    return {{"scene", scene_fingerprint(scene)},
            {"size", format_extent(options.width, options.height)},
            {"number of reflections", bounces_text(options)},
            {"device", fmt::format("{}, {}", device.name, device.driver)},
            {"version", options.version}};
}

/// Fraction of the whole experiment, by expected times.
class Progression {
public:
    Progression(const Progress& progress, const RunPlan& plan, double truth) : progress_(progress), plan_(plan), truth_(truth) {}

    void truth_done() { spent_ += truth_, truth_ = 0; }
    void run_done(double seconds) { spent_ += seconds; }

    /// `fraction` of a step that takes `step_seconds`.
    bool update(const std::string& stage, double fraction, double step_seconds, const std::vector<RunPoint>& points) const {
        const double left = truth_ + plan_.expected_seconds(points), total = spent_ + left;
        return !progress_ || progress_(stage, total > 0 ? (spent_ + std::min(fraction * step_seconds, left)) / total : 0);
    }
    double truth() const { return truth_; }

private:
    const Progress& progress_;
    const RunPlan& plan_;
    double truth_, spent_ = 0;
};

std::vector<std::string> with_path_tracer(const ConvergeOptions& options) {
    std::vector<std::string> names{path_tracer_name};
    names.insert(names.end(), options.methods.begin(), options.methods.end());
    return names;
}

class Experiment {
public:
    Experiment(const Scene& scene, const ConvergeOptions& options, const std::shared_ptr<Device>& device, const Progress& progress)
        : scene_(scene),
          options_(options),
          device_(device),
          plan_(with_path_tracer(options), options.seeds, options.longest),
          progression_(progress, plan_, options.reference.empty() ? truth_seconds(options) : 0) {
        RunLog log = finished_runs(options);
        points_ = std::move(log.points);
        if (!log.warning.empty()) {
            warnings_.push_back(log.warning);
        }
    }

    Report run() {
        Report report;
        report.options = options_;
        report.device = device_->info();
        report.host_threads = std::thread::hardware_concurrency();
        if (find_truth()) {
            Identity identity = identity_of(scene_, options_, device_->info());
            identity["reference"] = truth_.fingerprint;
            check_identity(options_.folder, identity, points_);
            write_identity(options_.folder, identity);
            report.finished = run_missing();
            report.truth = std::move(truth_);
            report.points = std::move(points_);
            report.methods = summarise(report.points, options_, report.truth);
            report.warnings = report.truth.warnings;
            report.warnings.insert(report.warnings.end(), warnings_.begin(), warnings_.end());
            const std::vector<std::string> more = run_warnings(report);
            report.warnings.insert(report.warnings.end(), more.begin(), more.end());
        }
        return report;
    }

private:
    /// False if interrupted.
    bool find_truth() {
        if (!options_.reference.empty()) {
            truth_ = read_truth(options_.reference, scene_, options_);
            return true;
        }
        const Progress progress = [this](const std::string& stage, double fraction) {
            return progression_.update(stage, fraction, progression_.truth(), points_);
        };
        std::optional<Truth> truth = own_truth(scene_, options_, progress);
        if (truth) {
            truth_ = std::move(*truth);
            progression_.truth_done();
        }
        return truth.has_value();
    }

    /// False if interrupted.
    bool run_missing() {
        bool warm = false;
        while (const std::optional<Task> task = plan_.next(points_)) {
            const double before = plan_.expected_seconds(points_);
            const std::string stage = fmt::format("{} {}, seed {}", task->method, run_flags(task->method, task->budget), task->seed);
            const Progress progress = [&](const std::string&, double fraction) {
                return progression_.update(stage, fraction, expected(*task), points_);
            };
            if (!warm) {
                warm_up(scene_, options_, device_,
                        [&](const std::string&, double) { return progression_.update("warm-up", 0, 0, points_); });
                warm = true;
            }
            if (!progression_.update(stage, 0, 0, points_) || !finish(*task, progress)) {
                return false;
            }
            progression_.run_done(std::max(0.0, before - plan_.expected_seconds(points_)));
        }
        return true;
    }

    /// Runs the task and stores its point, or ends its ladder. False if interrupted.
    bool finish(const Task& task, const Progress& progress) {
        try {
            const std::optional<RunPoint> point = run_task(task, scene_, options_, truth_, device_, progress);
            if (!point) {
                return false;
            }
            append_run(runs_file(options_), *point);
            points_.push_back(*point);
        } catch (const MemoryError& error) {
            plan_.end_ladder(task.method, task.budget);
            warnings_.push_back(fmt::format("{} stops before {}: {}", task.method, run_flags(task.method, task.budget), error.what()));
        }
        return true;
    }

    /// Time of the same run with seed 0, or of the step before.
    double expected(const Task& task) const {
        for (int budget = task.budget; budget >= 0; --budget) {
            if (const RunPoint* point = find_point(points_, task.method, budget, 0)) {
                return point->seconds;
            }
        }
        return 0;
    }

    const Scene& scene_;
    const ConvergeOptions& options_;
    std::shared_ptr<Device> device_;
    std::vector<RunPoint> points_;
    RunPlan plan_;
    Progression progression_;
    Truth truth_;
    std::vector<std::string> warnings_;
};

void write_text(const fs::path& file, const std::string& text) { write_file(file, text.data(), text.size()); }

}  // namespace

void prepare_folder(const Scene& scene, const ConvergeOptions& options, const DeviceInfo& device) {
    std::error_code error;
    fs::create_directories(options.folder / "images", error);
    if (error) {
        throw OutputError(fmt::format("cannot write to {}: {}", options.folder.string(), error.message()));
    }
    for (const fs::path& file : {runs_file(options), table_file(options), options.folder / "index.html", options.folder / "images/a.exr"}) {
        check_writable(file);
    }
    check_identity(options.folder, identity_of(scene, options, device), finished_runs(options).points);
}

Report converge(const Scene& scene, const ConvergeOptions& options, const std::shared_ptr<Device>& device, const Progress& progress) {
    Report report = Experiment(scene, options, device, progress).run();
    if (report.points.empty()) {
        return report;  // interrupted before the first run was finished
    }
    write_text(table_file(options), points_csv(report.points));
    write_text(options.folder / "summary.json", summary_json(report));
    const std::string missing = make_plots(options.folder);
    write_text(options.folder / "index.html", page_html(report, missing));
    if (!missing.empty()) {
        report.warnings.push_back(missing);
    }
    return report;
}

}  // namespace pencil
