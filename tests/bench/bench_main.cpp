// Microbenchmarks: google-benchmark's options and two of our own, --device D as in `pencil render` and --tiny, sizes that only check.
// Exit status 1 if a kernel and its native loop disagree.
#include <cstdio>
#include <cstring>
#include <thread>

#include "bench/bench.h"
#include "util/error.h"

namespace {

/// Takes our own options out of argv.
int take_options(int argc, char** argv) {
    int kept = 1;
    for (int i = 1; i < argc; ++i)
        if (std::strcmp(argv[i], "--tiny") == 0)
            pencil::bench::use_tiny_sizes();
        else if (std::strcmp(argv[i], "--device") == 0 && i + 1 < argc)
            pencil::bench::select_device(argv[++i]);
        else if (std::strncmp(argv[i], "--device=", 9) == 0)
            pencil::bench::select_device(argv[i] + 9);
        else
            argv[kept++] = argv[i];
    return kept;
}

void add_context() {
    const pencil::DeviceInfo& info = pencil::bench::device()->info();
    benchmark::AddCustomContext("device", info.name + " (" + info.platform + ", driver " + info.driver + ")");
    benchmark::AddCustomContext("packet_width", std::to_string(pencil::bench::device()->packet_width()));
    benchmark::AddCustomContext("native_threads", std::to_string(std::thread::hardware_concurrency()));
    benchmark::AddCustomContext("native_compiler", "g++ " __VERSION__ ", " PENCIL_NATIVE_FLAGS);
}

}  // namespace

int main(int argc, char** argv) {
    argc = take_options(argc, argv);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return static_cast<int>(pencil::ExitCode::usage);
    try {
        add_context();
        benchmark::RunSpecifiedBenchmarks();
    } catch (const pencil::Error& error) {
        std::fprintf(stderr, "pencil_bench: %s\n", error.what());
        return static_cast<int>(error.code());
    }
    return pencil::bench::any_mismatch() ? 1 : 0;
}
