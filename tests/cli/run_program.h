// Runs the program in a child process, as a user would, and keeps what it said. Used by the tests of cli and hostile.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pencil_test {

struct RunOptions {
    std::map<std::string, std::string> environment;  // added to ours
    long largest_file = 0;                           // [bytes], 0: no limit
    std::filesystem::path output;                    // where stdout goes; empty: kept
};

struct RunResult {
    int code = -1;   // exit status, or -1 if a signal ended it
    int signal = 0;  // that signal
    std::string out, err;
    double processor_time = 0;  // [s]
    long peak_memory = 0;       // [bytes]
};

/// Waits for it to end.
RunResult run(const std::vector<std::string>& command, const RunOptions& options = {});
/// run() of the program under test.
RunResult run_pencil(std::vector<std::string> arguments, const RunOptions& options = {});

/// A child that runs beside the test.
class Child {
public:
    explicit Child(const std::vector<std::string>& command, const RunOptions& options = {});
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    void send(int signal);
    /// Reads until stderr contains `text`; false if it ends first. How long that may take is the test runner's to say.
    bool wait_for_error_text(const std::string& text) { return wait_for(result_.err, text); }
    /// The same of stdout.
    bool wait_for_output_text(const std::string& text) { return wait_for(result_.out, text); }
    RunResult wait();

private:
    bool wait_for(const std::string& stream, const std::string& text);
    bool read_some(int timeout_ms);
    ::pid_t pid_ = -1;
    int out_ = -1, err_ = -1;
    RunResult result_;
};

}  // namespace pencil_test
