// `pencil document`: the tables of options as documentation, for docs/options.md and the man page.
#include <iostream>
#include <sstream>

#include "app/command_line.h"
#include "app/commands.h"

namespace pencil {

namespace {

/// Bars would end a cell of a Markdown table; angle brackets would be markup.
std::string cell(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '|') safe += "\\|";
        else if (c == '<') safe += "&lt;";
        else safe += c;
    }
    return safe;
}

std::string spelled(const Option& row) { return row.flag + (row.value.empty() ? "" : " " + row.value); }

void write_markdown(const SubCommand& command) {
    std::cout << "## pencil " << command.name << "\n\n" << command.summary << ".\n\n";
    if (command.table.empty()) return;
    std::cout << "| option | accepted | default | meaning |\n|---|---|---|---|\n";
    for (const Option& row : command.table)
        std::cout << "| `" << spelled(row) << "` | " << cell(row.accepted) << " | " << (row.required ? "required" : cell(row.standard)) << " | "
                  << (row.method.empty() ? "" : row.method + ": ") << cell(row.help) << " |\n";
    std::cout << "\n";
}

/// Text for troff: no line may begin with a control character, hyphens are hyphens.
std::string troff(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '-' || c == '\\') safe += '\\';
        safe += c;
    }
    return safe;
}

void write_man(const SubCommand& command) {
    std::cout << ".SH PENCIL " << troff(command.name) << "\n" << troff(command.summary) << ".\n";
    for (const Option& row : command.table) {
        std::cout << ".TP\n.B " << troff(spelled(row)) << "\n" << (row.method.empty() ? "" : "Method " + row.method + ": ") << troff(row.help) << ".";
        if (!row.accepted.empty()) std::cout << " Accepted: " << troff(row.accepted) << ".";
        if (row.required) std::cout << " Required.";
        else if (!row.standard.empty()) std::cout << " Default: " << troff(row.standard) << ".";
        std::cout << "\n";
    }
}

}  // namespace

ExitCode run_document(const DocumentCommand& command) {
    const bool man = command.format == "man";
    if (man)
        std::cout << ".TH PENCIL 1 \"\" \"pencil " PENCIL_VERSION "\"\n.SH NAME\npencil \\- global illumination by pencil light transport on any "
                     "OpenCL device\n.SH SYNOPSIS\n.B pencil\n.I command\n[options]\n";
    for (const SubCommand& sub : sub_commands())
        if (!sub.hidden) (man ? write_man : write_markdown)(sub);
    std::cout << (man ? ".SH EXIT STATUS\n" : "## Exit status\n\n") << (man ? troff(exit_codes) : exit_codes) << "\n";
    return ExitCode::ok;
}

}  // namespace pencil
