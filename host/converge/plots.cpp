#include "converge/plots.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "converge/embedded_text.h"
#include "util/environment.h"
#include "util/output_file.h"

namespace pencil {
namespace {

constexpr int no_matplotlib = 3;  // exit status of plot.py

std::vector<std::string> interpreters() {
    const std::string chosen = environment("PENCIL_PYTHON");
    if (!chosen.empty()) return {chosen};
    return {"python3", "/usr/bin/python3"};
}

/// Runs `arguments` with nothing to read and its output on stderr. The exit status, or -1 with errno if it cannot be started.
int run(std::vector<std::string> arguments) {
    std::vector<char*> pointers;
    pointers.reserve(arguments.size() + 1);
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files, STDERR_FILENO, STDOUT_FILENO);
    pid_t child = 0;
    const int error = ::posix_spawnp(&child, pointers[0], &files, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) {
        errno = error;
        return -1;
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

}  // namespace

std::string make_plots(const std::filesystem::path& folder) {
    const std::filesystem::path script = folder / "plot.py";
    write_file(script, plot_script, std::strlen(plot_script));
    std::string reasons;
    for (const std::string& python : interpreters()) {
        const int status = run({python, script.string(), folder.string()});
        if (status == 0) return "";
        const std::string reason = status == -1              ? std::string(std::strerror(errno))
                                   : status == no_matplotlib ? "has no matplotlib"
                                                             : fmt::format("failed with status {}", status);
        reasons += fmt::format("{}{}: {}", reasons.empty() ? "" : "; ", python, reason);
    }
    return fmt::format("no plots ({}); install python3-matplotlib and run the same command again", reasons);
}

}  // namespace pencil
