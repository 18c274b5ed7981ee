// `pencil build-kernels`: what a render starts beside itself, to build kernels.
#include <csignal>
#include <iostream>

#include "app/commands.h"
#include "cl/build_ahead.h"

namespace pencil {

ExitCode run_build_kernels(const BuildKernelsCommand&) {
    // It ends with the render, which goes on to its first image when it is interrupted.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
    build_kernels(std::cin);
    return ExitCode::ok;
}

}  // namespace pencil
