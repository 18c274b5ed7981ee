// Runs one test of this executable in a process of its own, with other environment variables: drivers read theirs once.
// The child's part is a test whose name starts with DISABLED_, so that it does not run by itself.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <string>

struct ChildResult {
    int status = -1;     // exit status, or 128 + signal
    std::string output;  // stdout and stderr
};

/// `environment`: arguments of env(1), for example "-u HOME POCL_DEVICES=basic"; `wrapper` goes before the program ("oclgrind").
inline ChildResult run_child_test(const std::string& test, const std::string& environment, const std::string& wrapper = "") {
    char self[4096];
    const ssize_t length = readlink("/proc/self/exe", self, sizeof self);
    if (length <= 0) return {};
    const std::string command = "env " + environment + " " + wrapper + " '" + std::string(self, static_cast<std::size_t>(length)) +
                                "' --gtest_also_run_disabled_tests --gtest_filter='" + test + "' 2>&1";
    ChildResult result;
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return result;
    char text[4096];
    while (std::size_t count = fread(text, 1, sizeof text, pipe)) result.output.append(text, count);
    const int status = pclose(pipe);
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return result;
}
