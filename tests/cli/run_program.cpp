// POSIX calls; what the children inherit is only what each test gives them.
#include "cli/run_program.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace pencil_test {
namespace {

struct Pipe {
    std::array<int, 2> ends{-1, -1};
    Pipe() {
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("pipe failed");
    }
};

[[noreturn]] void become(const std::vector<std::string>& command, const RunOptions& options, int out, int err) {
    ::setenv("PENCIL_TUNED", "0", 1);  // who has tuned what is none of a test's business, unless it says so
    for (const auto& [name, value] : options.environment) ::setenv(name.c_str(), value.c_str(), 1);
    if (options.largest_file > 0) {
        const struct rlimit limit { static_cast<rlim_t>(options.largest_file), static_cast<rlim_t>(options.largest_file) };
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    if (!options.output.empty()) out = ::open(options.output.c_str(), O_WRONLY);
    ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    ::execvp(arguments.front(), arguments.data());
    ::_exit(127);
}

/// False at the end of the stream.
bool append(int descriptor, std::string& text) {
    std::array<char, 4096> buffer;
    const ::ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
    return count > 0;
}

void close_if_open(int& descriptor) {
    if (descriptor >= 0) {
        ::close(descriptor);
        descriptor = -1;
    }
}

}  // namespace

Child::Child(const std::vector<std::string>& command, const RunOptions& options) {
    const Pipe out, err;
    pid_ = ::fork();
    if (pid_ < 0) throw std::runtime_error("fork failed");
    if (pid_ == 0) become(command, options, out.ends[1], err.ends[1]);
    ::close(out.ends[1]);
    ::close(err.ends[1]);
    out_ = out.ends[0];
    err_ = err.ends[0];
}

Child::~Child() {
    if (pid_ > 0) {
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
    }
    close_if_open(out_);
    close_if_open(err_);
}

void Child::send(int signal) { ::kill(pid_, signal); }

bool Child::read_some(int timeout_ms) {
    std::array<struct pollfd, 2> streams{{{out_, POLLIN, 0}, {err_, POLLIN, 0}}};  // poll skips negative ones
    if (out_ < 0 && err_ < 0) return false;
    if (::poll(streams.data(), streams.size(), timeout_ms) <= 0) return true;
    if (streams[0].revents != 0 && !append(out_, result_.out)) close_if_open(out_);
    if (streams[1].revents != 0 && !append(err_, result_.err)) close_if_open(err_);
    return true;
}

bool Child::wait_for(const std::string& stream, const std::string& text) {
    while (stream.find(text) == std::string::npos)
        if (!read_some(1000)) return false;
    return true;
}

RunResult Child::wait() {
    while (read_some(1000)) {
    }
    int status = 0;
    struct rusage used {};
    ::wait4(pid_, &status, 0, &used);
    pid_ = -1;
    const auto seconds = [](const struct timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    result_.processor_time = seconds(used.ru_utime) + seconds(used.ru_stime);
    result_.peak_memory = 1024 * used.ru_maxrss;
    result_.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    result_.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return result_;
}

RunResult run(const std::vector<std::string>& command, const RunOptions& options) { return Child(command, options).wait(); }

RunResult run_pencil(std::vector<std::string> arguments, const RunOptions& options) {
    arguments.insert(arguments.begin(), PENCIL_PROGRAM);
    return run(arguments, options);
}

}  // namespace pencil_test
