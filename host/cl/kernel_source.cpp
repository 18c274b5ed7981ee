#include "cl/kernel_source.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <vector>

#include "cl/embedded_kernels.h"
#include "util/environment.h"
#include "util/error.h"

namespace pencil {

namespace {

const std::string programs_folder = "programs/";

std::string read_from_disk(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) throw DeviceError("cannot read the kernel file " + path.string());
    return text.str();
}

bool begins_with(const std::string& line, const std::string& word) {
    const std::size_t start = line.find_first_not_of(" \t");
    return start != std::string::npos && line.compare(start, word.size(), word) == 0;
}

/// "lib/x.cl" of the line #include "lib/x.cl".
std::optional<std::string> included(const std::string& line) {
    if (!begins_with(line, "#include \"")) return {};
    const std::size_t open = line.find('"'), close = line.find('"', open + 1);
    return close == std::string::npos ? std::nullopt : std::optional(line.substr(open + 1, close - open - 1));
}

std::string line_directive(int line, const std::string& file) { return "#line " + std::to_string(line) + " \"" + file + "\"\n"; }

/// Files as the compiler's messages show them.
std::string shown(const std::string& file) {
    const std::filesystem::path path(file);
    return path.is_absolute() ? path.filename().string() : file;
}

/// Embedded files that a name with one star stands for, in alphabetical order.
std::vector<std::string> matching_files(const std::string& pattern) {
    const std::string before = pattern.substr(0, pattern.find('*')), after = pattern.substr(pattern.find('*') + 1);
    std::vector<std::string> files;
    for (const auto& entry : embedded_kernels()) {
        const std::string& file = entry.first;
        const bool fits = file.size() >= before.size() + after.size() && file.compare(0, before.size(), before) == 0 &&
                          file.compare(file.size() - after.size(), after.size(), after) == 0;
        if (fits) files.push_back(file);
    }
    return files;
}

/// Kernels that only tests use include what lies beside them, too.
std::string place_of(const std::string& name, const std::string& includer) {
    const std::filesystem::path beside = std::filesystem::path(includer).parent_path() / name;
    return beside.is_absolute() && std::filesystem::exists(beside) ? beside.string() : name;
}

class Resolver {
public:
    /// `file`: what the main text is, which is not included once more.
    explicit Resolver(const std::string& file) : taken_{file} {}

    /// Appends `text` with its includes; `conditional`: it stands between #if and #endif.
    void append(const std::string& text, const std::string& file, bool conditional) {
        out_ += line_directive(1, shown(file));
        std::istringstream lines(text);
        std::string line;
        int number = 1, depth = 0;
        for (; std::getline(lines, line); ++number) {
            if (begins_with(line, "#pragma once")) line.clear();  // each file is taken once; the main text would warn
            if (begins_with(line, "#if")) ++depth;
            if (begins_with(line, "#endif")) --depth;
            if (const std::optional<std::string> name = included(line)) {
                include(place_of(*name, file), shown(file) + ":" + std::to_string(number), conditional || depth > 0, conditional);
                out_ += line_directive(number + 1, shown(file));
            } else {
                out_ += line + "\n";
            }
        }
    }

    std::string take() { return std::move(out_); }

private:
    void include(const std::string& name, const std::string& where, bool conditional, bool nested) {
        if (name.find('*') != std::string::npos) {
            for (const std::string& file : matching_files(name)) include(file, where, conditional, nested);
            return;
        }
        if (taken_.count(name) > 0) return;
        if (nested) throw DeviceError(where + ": " + name + " must be included before the #if that this file stands in");
        taken_.insert(name);
        std::string text;
        try {
            text = kernel_source(name);
        } catch (const DeviceError& error) {
            throw DeviceError(where + ": " + error.what());
        }
        append(text, name, conditional);
    }

    std::set<std::string> taken_;
    std::string out_;
};

/// Programs by the kernel files that they include.
std::map<std::string, std::string> find_programs() {
    std::map<std::string, std::string> programs;
    for (const auto& [file, text] : embedded_kernels()) {
        if (file.compare(0, programs_folder.size(), programs_folder) != 0) continue;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);)
            if (const std::optional<std::string> name = included(line)) programs[*name] = file;
    }
    return programs;
}

/// find_programs, once.
const std::map<std::string, std::string>& programs() {
    static const std::map<std::string, std::string> found = find_programs();
    return found;
}

}  // namespace

std::string kernel_source(const std::string& file) {
    const std::filesystem::path path(file);
    if (path.is_absolute()) return read_from_disk(path);
    const std::string folder = environment("PENCIL_KERNEL_DIR");
    if (!folder.empty()) return read_from_disk(std::filesystem::path(folder) / path);
    const auto found = embedded_kernels().find(file);
    if (found == embedded_kernels().end()) throw DeviceError("no kernel file named " + file + " is built into the program");
    return found->second;
}

std::string resolve_includes(const std::string& text, const std::string& file) {
    Resolver resolver(file);
    resolver.append(text, file, false);
    return resolver.take();
}

std::string program_source(const std::string& file) { return resolve_includes(kernel_source(file), file); }

std::string program_of(const std::string& kernel) {
    const auto found = programs().find(kernel + ".cl");
    return found == programs().end() ? kernel + ".cl" : found->second;
}

std::vector<std::string> program_files() {
    std::vector<std::string> files;
    for (const auto& entry : embedded_kernels()) {
        const std::string& file = entry.first;
        const bool kernels = std::filesystem::path(file).extension() == ".cl" && file.find('/') == std::string::npos;
        const bool whole = file.compare(0, programs_folder.size(), programs_folder) == 0;
        if (whole || (kernels && programs().count(file) == 0)) files.push_back(file);
    }
    return files;
}

}  // namespace pencil
