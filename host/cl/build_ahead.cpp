// The render builds from the front as it goes; every process begins elsewhere and goes backwards through the whole list. They meet where the
// driver finds what the other has built, so nobody waits, and a process that fails is only missed.
#include "cl/build_ahead.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <istream>
#include <sstream>
#include <thread>

#include "cl/kernel_source.h"
#include "cl/pocl_cache.h"
#include "util/environment.h"
#include "util/error.h"
#include "util/fingerprint.h"
#include "util/log.h"

#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace pencil {
namespace {

// Each takes about 0.9 s to load the driver's compiler before its first kernel; a render has two to three seconds of builds for each of four.
constexpr std::size_t most_processes = 3;

std::string lines(const std::vector<KernelBuild>& builds) {
    std::string text;
    for (const KernelBuild& build : builds) {
        text += fmt::format("{} {}", build.kernel, build.items);
        for (const auto& [name, value] : build.defines) text += fmt::format(" {}={}", name, value);
        text += "\n";
    }
    return text;
}

std::vector<KernelBuild> read_lines(std::istream& list) {
    std::vector<KernelBuild> builds;
    for (std::string line; std::getline(list, line);) {
        std::istringstream words(line);
        KernelBuild build;
        words >> build.kernel >> build.items;
        for (std::string define; words >> define;) build.defines[define.substr(0, define.find('='))] = define.substr(define.find('=') + 1);
        builds.push_back(build);
    }
    return builds;
}

/// A file that says that all of it is in PoCL's cache: it lies there, so that it goes where the cache goes.
std::filesystem::path mark(const Device& device, const std::string& text, const std::vector<KernelBuild>& builds) {
    std::string identity = device.info().name + "\n" + device.info().driver + "\n" + text + fmt::format("{}", device.packet_width());
    for (const KernelBuild& build : builds) identity += fmt::format(" {}", device.local_size(build.kernel));
    std::string last;
    for (const KernelBuild& build : builds) {
        const std::string file = program_of(build.kernel);
        if (file != last) identity += program_source(file);
        last = file;
    }
    return pocl_cache() / ("pencil-" + fingerprint(identity.data(), identity.size()));
}

/// That this process may use.
std::size_t cores() {
#ifdef __linux__
    cpu_set_t mine;
    if (sched_getaffinity(0, sizeof mine, &mine) == 0) return std::max<std::size_t>(static_cast<std::size_t>(CPU_COUNT(&mine)), 1);
#endif
    return std::max<std::size_t>(std::thread::hardware_concurrency(), 1);
}

std::filesystem::path& builder() {
    static std::filesystem::path program;
    return program;
}

pid_t start(const std::string& input) {
    std::FILE* file = std::tmpfile();
    if (!file) return -1;
    std::fwrite(input.data(), 1, input.size(), file);
    std::fflush(file);
    std::rewind(file);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, fileno(file), STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    char name[] = "pencil", command[] = "build-kernels";
    char* arguments[] = {name, command, nullptr};
    pid_t process = -1;
    if (posix_spawn(&process, builder().c_str(), &actions, nullptr, arguments, environ) != 0) process = -1;
    posix_spawn_file_actions_destroy(&actions);
    std::fclose(file);
    return process;
}

}  // namespace

void allow_build_ahead(const std::filesystem::path& program) { builder() = program; }

BuildAhead::BuildAhead(const Device& device, const std::vector<KernelBuild>& builds) {
    if (builder().empty() || builds.empty()) return;
    if (device.info().platform != pocl_platform || environment("POCL_KERNEL_CACHE") == "0") return;
    const std::string text = lines(builds);
    const std::filesystem::path all_built = mark(device, text, builds);
    std::error_code none;
    const std::size_t count = std::min(cores() - 1, most_processes);
    if (count == 0 || std::filesystem::exists(all_built, none)) return;
    log_info("building kernels for " + device.info().name);
    for (std::size_t i = 1; i <= count; ++i) {
        const std::size_t from = builds.size() * (i + 1) / (count + 1) - 1;
        const pid_t process = start(fmt::format("{} {} {}\n{}\n{}", getpid(), device.info().index, from, all_built.string(), text));
        if (process > 0) processes_.push_back(process);
    }
}

BuildAhead::~BuildAhead() {
    for (const pid_t process : processes_) {
        if (waitpid(process, nullptr, WNOHANG) != 0) continue;  // it has ended, or is no child any more
        kill(process, SIGKILL);
        waitpid(process, nullptr, 0);
    }
}

void build_kernels(std::istream& list) {
    int index = 0;
    std::size_t from = 0;
    pid_t parent = 0;
    std::string all_built;
    list >> parent >> index >> from >> std::ws;
    std::getline(list, all_built);
    const std::vector<KernelBuild> builds = read_lines(list);
    if (builds.empty()) throw UsageError("build-kernels is started by a render, with a list of kernels");
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    if (getppid() != parent) return;
    ProgramCache programs(Device::open(std::to_string(index)));
    for (std::size_t i = 0; i < builds.size(); ++i) {
        const KernelBuild& build = builds[(from + builds.size() - i) % builds.size()];
        programs.kernel(build.kernel, program_of(build.kernel), build.defines).make_code(build.items);
        programs.device()->finish();
    }
    std::ofstream(all_built).flush();
}

}  // namespace pencil
