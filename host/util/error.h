// Errors that end a command. Each says what was being done, where, and what to try; the code becomes the exit status.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pencil {

enum class ExitCode { ok = 0, usage = 2, scene = 3, device = 4, memory = 5, output = 6, interrupted = 7, not_converged = 8, not_held = 9 };

class Error : public std::runtime_error {
public:
    Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    ExitCode code() const { return code_; }

private:
    ExitCode code_;
};

struct UsageError : Error {
    explicit UsageError(const std::string& message) : Error(ExitCode::usage, message) {}
};
/// `where` is "file:line" or a file name.
struct SceneError : Error {
    SceneError(const std::string& where, const std::string& message) : Error(ExitCode::scene, where + ": " + message) {}

protected:
    explicit SceneError(const std::string& text) : Error(ExitCode::scene, text) {}
};
/// All defects of a scene; what() strings them together.
struct SceneErrors : SceneError {
    explicit SceneErrors(std::vector<std::string> texts) : SceneError(joined(texts)), each(std::move(texts)) {}
    std::vector<std::string> each;

private:
    static std::string joined(const std::vector<std::string>& texts) {
        std::string result;
        for (const std::string& text : texts) result += (result.empty() ? "" : "; ") + text;
        return result;
    }
};
struct DeviceError : Error {
    explicit DeviceError(const std::string& message) : Error(ExitCode::device, message) {}
};
struct MemoryError : Error {
    explicit MemoryError(const std::string& message) : Error(ExitCode::memory, message) {}
};
struct OutputError : Error {
    explicit OutputError(const std::string& message) : Error(ExitCode::output, message) {}
};

}  // namespace pencil
