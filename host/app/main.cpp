// The program `pencil`: runs the command line and turns every exception into a message and an exit status.
#include <exception>
#include <iostream>
#include <new>

#include "app/command_line.h"
#include "app/interrupt.h"
#include "app/message.h"
#include "util/error.h"

namespace pencil {
namespace {

/// Results on stdout count as output, too: `pencil info > /dev/full` has failed.
void check_standard_output() {
    std::cout.flush();
    if (!std::cout) throw OutputError("cannot write to the standard output");
}

ExitCode guarded(int argc, char** argv) {
    try {
        const ExitCode code = run_command_line(argc, argv);
        check_standard_output();
        return code;
    } catch (const DeviceError& error) {
        // A driver that is building a kernel may be what a signal ended.
        const bool interrupted = interrupted_by() != 0;
        print_error(interrupted ? "interrupted before there was an image; nothing is written" : error.what(), LineBreaks::keep);
        return interrupted ? ExitCode::interrupted : error.code();
    } catch (const SceneErrors& errors) {
        for (const std::string& text : errors.each) print_error(text);
        return errors.code();
    } catch (const Error& error) {
        print_error(error.what(), error.code() == ExitCode::memory ? LineBreaks::keep : LineBreaks::escape);
        if (error.code() == ExitCode::usage) std::cerr << "Run with --help for the options.\n";
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
