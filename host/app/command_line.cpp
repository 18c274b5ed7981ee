#include "app/command_line.h"

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "app/interrupt.h"
#include "cl/profile_file.h"

namespace pencil {

namespace {

template <typename Command>
SubCommand sub_command(const std::string& name, const std::string& summary, ExitCode (*run)(const Command&)) {
    const auto command = std::make_shared<Command>();
    const std::vector<Option> table = option_table(*command);
    return {name, summary, table, [command, table](const Given& given) { settle(*command, table, given); },
            [command, run] { return run(*command); }};
}

SubCommand hidden(SubCommand command) {
    command.hidden = true;
    return command;
}

/// "--map" of the message's "--map: ...".
void read(const Option& row, const std::string& text) {
    try {
        row.read(text);
    } catch (const std::invalid_argument& error) {
        const std::string flag = row.flag.substr(0, row.flag.find(','));
        throw CLI::ValidationError(flag, error.what());
    }
}

std::string help_of(const Option& row) { return methods_text(row) + row.help + (row.accepted.empty() ? "" : " [" + row.accepted + "]"); }

CLI::Option* add(CLI::App& app, const Option& row) {
    if (row.flag.front() == '-' && row.value.empty())
        return app.add_flag_callback(
            row.flag, [&row] { read(row, ""); }, help_of(row));
    const auto read_all = [&row](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) read(row, text);
    };
    CLI::Option* option = row.repeated ? app.add_option_function<std::vector<std::string>>(row.flag, read_all, help_of(row))
                                       : app.add_option_function<std::string>(
                                             row.flag, [&row](const std::string& text) { read(row, text); }, help_of(row));
    option->type_name(row.value)->default_str(row.standard)->required(row.required);
    if (row.repeated) option->allow_extra_args(false);
    return option;
}

/// The name that CLI11 finds an option by.
std::string lookup_name(const Option& row) { return row.flag.substr(row.flag.rfind(',') + 1); }

void declare(CLI::App& app, const SubCommand& command) {
    CLI::App* sub = app.add_subcommand(command.name, command.summary);
    if (command.hidden) sub->group("");
    for (const Option& row : command.table) add(*sub, row);
    sub->footer(exit_codes);
    sub->parse_complete_callback([sub, &command] {
        try {
            command.settle([sub](const Option& row) { return sub->count(lookup_name(row)) > 0; });
        } catch (const std::invalid_argument& error) {
            throw CLI::ValidationError(error.what());
        }
    });
}

std::string names(const std::vector<SubCommand>& commands) {
    std::vector<std::string> shown;
    for (const SubCommand& command : commands)
        if (!command.hidden) shown.push_back(command.name);
    return join(shown);
}

}  // namespace

const char* const exit_codes =
    "Exit status: 0 ok, 2 usage, 3 scene, 4 device, 5 memory, 6 output, 7 interrupted with the partial result written, 8 the image "
    "is written but its reflections have no sum (a warning says why), 9 a case of stress fails.";

std::vector<SubCommand> sub_commands() {
    return {
        sub_command("render", "Render a scene to image files", run_render),
        sub_command("reference", "Render a scene by path tracing, to judge other images by", run_reference),
        sub_command("bake", "Keep the light of a scene in a field of pencils, which `render --field` shows from any camera", run_bake),
        sub_command("walk", "Show a field of pencils from a row of cameras", run_walk),
        sub_command("measure", "Measure illuminance at points, on grids and by the meters of a scene", run_measure),
        sub_command("info", "Say what is in a scene and what rendering it needs", run_info),
        sub_command("compare", "Measure the error of an image against a reference", run_compare),
        sub_command("converge", "Measure error against run time of all methods and the path tracer", run_converge),
        sub_command("stress", "Render scenes that are stiff or extreme and check what comes out", run_stress),
        sub_command("tune", "Measure variants of the kernels on a device, and keep the fastest for renders on it", run_tune),
        sub_command("devices", "List the OpenCL devices", run_devices),
        hidden(sub_command("document", "Write the options of all commands as documentation, or the programs of kernels", run_document)),
        hidden(sub_command("build-kernels", "Build the kernels that the standard input lists into the driver's cache", run_build_kernels))};
}

ExitCode run_command_line(int argc, char** argv) {
    const std::vector<SubCommand> commands = sub_commands();
    CLI::App app{"pencil renders global illumination by pencil light transport on any OpenCL device.", "pencil"};
    app.set_version_flag("--version", "pencil " PENCIL_VERSION);
    app.require_subcommand(0, 1);  // none is refused below, after unknown words
    app.footer(exit_codes);
    for (const SubCommand& command : commands) declare(app, command);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        app.exit(success);  // prints the help or the version
        return ExitCode::ok;
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    watch_signals();
    allow_tuned_profiles();
    for (const SubCommand& command : commands)
        if (app.got_subcommand(command.name)) return command.run();
    throw UsageError("a command is required: " + names(commands));
}

}  // namespace pencil
