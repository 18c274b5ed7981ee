// The experiment: every method over its budgets and seeds, and the path tracer beside them, measured against one truth.
#pragma once

#include <memory>

#include "converge/report.h"

namespace pencil {

/// Creates the folder and tries it. OutputError if it cannot be written to, UsageError if it holds other runs. Before any work.
void prepare_folder(const Scene& scene, const ConvergeOptions& options, const DeviceInfo& device);

/// Runs what is missing in the folder, adding each finished run to runs.jsonl at once; then writes points.csv, summary.json, the plots and
/// index.html from all runs. If `progress` stops it, the files are written of what there is and Report::finished is false. The time of a
/// run never includes another's. Errors of the scene, the reference, the device and the output are thrown.
Report converge(const Scene& scene, const ConvergeOptions& options, const std::shared_ptr<Device>& device, const Progress& progress);

}  // namespace pencil
