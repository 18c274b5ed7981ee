// The tables of options of the sub-commands, those of options/ among them. A row is bound to the command's field that it sets.
#pragma once

#include <functional>
#include <vector>

#include "app/commands.h"
#include "options/option.h"

namespace pencil {

std::vector<Option> option_table(RenderCommand& command);
std::vector<Option> option_table(ReferenceCommand& command);
std::vector<Option> option_table(BakeCommand& command);
std::vector<Option> option_table(WalkCommand& command);
std::vector<Option> option_table(MeasureCommand& command);
std::vector<Option> option_table(InfoCommand& command);
std::vector<Option> option_table(CompareCommand& command);
std::vector<Option> option_table(ConvergeCommand& command);
std::vector<Option> option_table(StressCommand& command);
std::vector<Option> option_table(TuneCommand& command);
std::vector<Option> option_table(DevicesCommand& command);
std::vector<Option> option_table(DocumentCommand& command);
std::vector<Option> option_table(BuildKernelsCommand& command);

/// True if the command line holds an option.
using Given = std::function<bool(const Option&)>;

/// What no single option can judge, once all are read; std::invalid_argument. An option that only one method knows selects that method, and
/// is refused beside another.
void settle(RenderCommand& command, const std::vector<Option>& table, const Given& given);
void settle(ReferenceCommand& command, const std::vector<Option>& table, const Given& given);
void settle(MeasureCommand& command, const std::vector<Option>& table, const Given& given);
void settle(StressCommand& command, const std::vector<Option>& table, const Given& given);
template <typename Command>
void settle(Command&, const std::vector<Option>&, const Given&) {}

}  // namespace pencil
