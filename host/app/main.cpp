// The program `pencil`: reads the command line, runs one sub-command, and turns every exception into a message and an exit status.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <new>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/message.h"
#include "app/options.h"
#include "util/error.h"

namespace pencil {
namespace {

const char* const exit_codes =
    "Exit status: 0 ok, 2 usage, 3 scene, 4 device, 5 memory, 6 output, 7 interrupted with the partial result written.";

struct CommandLine {
    CLI::App app{"pencil renders global illumination by pencil light transport on any OpenCL device.", "pencil"};
    RenderCommand render;
    ReferenceCommand reference;
    InfoCommand info;
    CompareCommand compare;
    ConvergeCommand converge;
    DevicesCommand devices;
    CLI::App* render_app = nullptr;
    CLI::App* reference_app = nullptr;
    CLI::App* info_app = nullptr;
    CLI::App* compare_app = nullptr;
    CLI::App* converge_app = nullptr;
    CLI::App* devices_app = nullptr;

    CommandLine() {
        app.set_version_flag("--version", "pencil " PENCIL_VERSION);
        app.require_subcommand(0, 1);  // none is refused below, after unknown words
        app.footer(exit_codes);
        render_app = app.add_subcommand("render", "Render a scene to image files");
        reference_app = app.add_subcommand("reference", "Render a scene by path tracing, to judge other images by");
        info_app = app.add_subcommand("info", "Say what is in a scene and what rendering it needs");
        compare_app = app.add_subcommand("compare", "Measure the error of an image against a reference");
        converge_app = app.add_subcommand("converge", "Measure error against run time of all methods and the path tracer");
        devices_app = app.add_subcommand("devices", "List the OpenCL devices");
        add_render_options(*render_app, render);
        add_reference_options(*reference_app, reference);
        add_info_options(*info_app, info);
        add_compare_options(*compare_app, compare);
        add_converge_options(*converge_app, converge);
        add_devices_options(*devices_app, devices);
        render_app->footer(exit_codes);
        reference_app->footer(exit_codes);
    }
};

ExitCode run_command(const CommandLine& line) {
    if (line.render_app->parsed()) {
        return run_render(line.render);
    }
    if (line.reference_app->parsed()) {
        return run_reference(line.reference);
    }
    if (line.info_app->parsed()) {
        return run_info(line.info);
    }
    if (line.compare_app->parsed()) {
        return run_compare(line.compare);
    }
    if (line.converge_app->parsed()) {
        return run_converge(line.converge);
    }
    if (line.devices_app->parsed()) {
        return run_devices(line.devices);
    }
    throw UsageError("a command is required: render, reference, compare, converge, info or devices");
}

ExitCode parse_and_run(int argc, char** argv) {
    CommandLine line;
    try {
        line.app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        line.app.exit(success);  // prints the help or the version
        return ExitCode::ok;
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    watch_signals();
    return run_command(line);
}

/// Results on stdout count as output, too: `pencil info > /dev/full` has failed.
void check_standard_output() {
    std::cout.flush();
    if (!std::cout) {
        throw OutputError("cannot write to the standard output");
    }
}

ExitCode guarded(int argc, char** argv) {
    try {
        const ExitCode code = parse_and_run(argc, argv);
        check_standard_output();
        return code;
    } catch (const Error& error) {
        const bool log = error.code() == ExitCode::device || error.code() == ExitCode::memory;
        print_error(error.what(), log ? LineBreaks::keep : LineBreaks::escape);
        if (error.code() == ExitCode::usage) {
            std::cerr << "Run with --help for the options.\n";
        }
        return error.code();
    } catch (const std::bad_alloc&) {
        print_error("out of memory; try a smaller --resolution, fewer --pencils, a smaller --map or --aov none");
        return ExitCode::memory;
    } catch (const std::exception& error) {
        // Nothing of ours throws other types; what the OpenCL wrapper lets through is the likeliest.
        print_error(std::string("unexpected: ") + error.what(), LineBreaks::keep);
        return ExitCode::device;
    }
}

}  // namespace
}  // namespace pencil

int main(int argc, char** argv) { return static_cast<int>(pencil::guarded(argc, argv)); }
