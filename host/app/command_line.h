// The command line, built from the tables of options by CLI11.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/options.h"

namespace pencil {

/// A sub-command: its table, and what runs it once the table's rows have been read.
struct SubCommand {
    std::string name, summary;
    std::vector<Option> table;
    std::function<void(const Given&)> settle;
    std::function<ExitCode()> run;
    bool hidden = false;
};

/// All of them; a new one is a new entry.
std::vector<SubCommand> sub_commands();

/// "Exit status: ...".
extern const char* const exit_codes;

/// Reads the arguments and runs what they ask for. UsageError for what is wrong with them.
ExitCode run_command_line(int argc, char** argv);

}  // namespace pencil
