// The sub-commands. Each throws pencil::Error for what ends it and returns the exit code otherwise.
#pragma once

#include "app/options.h"
#include "util/error.h"

namespace pencil {

ExitCode run_render(const RenderCommand& command);
ExitCode run_reference(const ReferenceCommand& command);
ExitCode run_info(const InfoCommand& command);
ExitCode run_compare(const CompareCommand& command);
ExitCode run_converge(const ConvergeCommand& command);
ExitCode run_devices(const DevicesCommand& command);

}  // namespace pencil
