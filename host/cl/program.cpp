// Programs: source text from the embedded files or from disk, build options, build errors that can be acted on.
#include "cl/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "cl/cl_error.h"
#include "cl/kernel_source.h"
#include "util/environment.h"
#include "util/error.h"
#include "util/log.h"

namespace pencil {
namespace {

constexpr const char* build_flags = "-cl-std=CL1.2 -cl-kernel-arg-info";

// Clang warns that vectors wider than the CPU's registers pass differently than with other -m options; a program is one unit, so nothing
// can disagree. Asked for by PENCIL_WIDTH beyond the native width.
constexpr const char* prelude =
    "#ifdef __clang__\n"
    "#if __has_warning(\"-Wpsabi\")\n"
    "#pragma clang diagnostic ignored \"-Wpsabi\"\n"
    "#endif\n"
    "#endif\n"
    // Work-items work on packets: a driver that packs work-items once more (Intel's) takes three times as long to build, and to run some kernels.
    "#if PENCIL_WIDTH > 1\n"
    "#define PENCIL_JOINED(a, b) a##b\n"
    "#define PENCIL_WIDE(n) PENCIL_JOINED(float, n)\n"
    "#define kernel __kernel __attribute__((vec_type_hint(PENCIL_WIDE(PENCIL_WIDTH))))\n"
    "#endif\n";

// Options are split at blanks by the driver, so a blank in a value would silently become another option.
std::string build_options(const Defines& defines) {
    std::string options = build_flags;
    // A new warning of some driver is no reason to refuse a device, but one to mend the kernel: tests set this.
    if (!environment("PENCIL_KERNEL_WERROR").empty()) options += " -Werror";
    for (const auto& [name, value] : defines) {
        constexpr const char* special = " \t\n\"'\\";
        if (name.empty() || name.find_first_of(special) != std::string::npos || value.find_first_of(special) != std::string::npos)
            throw DeviceError(fmt::format("the define {}={} holds a blank or quote, which build options cannot carry", name, value));
        options.append(" -D ").append(name).append("=").append(value);
    }
    return options;
}

// FNV-1a: names files only, so collisions cost nothing but a file.
unsigned hash(const std::string& text) {
    unsigned value = 2166136261u;
    for (unsigned char c : text) value = (value ^ c) * 16777619u;
    return value;
}

void dump_source(const std::string& folder, const std::string& file, const Defines& defines, const std::string& source) {
    const std::string options = build_options(defines);
    char suffix[16];
    std::snprintf(suffix, sizeof suffix, "-%08x.cl", hash(file + options));
    const std::filesystem::path path = std::filesystem::path(folder) / (std::filesystem::path(file).stem().string() + suffix);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::ofstream out(path, std::ios::binary);
    out << "// " << file << "\n// build options: " << build_flags << "\n";
    for (const auto& [name, value] : defines) out << "#define " << name << " " << value << "\n";
    out << source;
    if (!out.flush()) log_warning("PENCIL_DUMP_KERNELS: cannot write " + path.string());
}

std::string build_log(const cl::Program& program, const cl::Device& device) {
    try {
        return program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device);
    } catch (const cl::Error&) {
        return "(no log)";
    }
}

/// Empty if the driver gives none.
ProgramBinaries::Binary program_binary(const cl::Program& program) {
    try {
        const auto binaries = program.getInfo<CL_PROGRAM_BINARIES>();
        return binaries.empty() ? ProgramBinaries::Binary() : binaries.front();
    } catch (const cl::Error&) {
        return {};
    }
}

}  // namespace

Launch ProgramCache::kernel(const std::string& name, const std::string& file, const Defines& defines) {
    const Defines& all = used(file, defines);
    const std::string options = build_options(all), key = file + " " + options;
    const auto program = programs_.find(key);
    const cl::Program& built = program != programs_.end() ? program->second : programs_.emplace(key, build(file, all)).first->second;
    // A kernel object of its own for every Launch: arguments belong to the object, and two launches may be prepared at once.
    cl::Kernel kernel;
    try {
        kernel = cl::Kernel(built, name.c_str());
    } catch (const cl::Error& error) {
        throw_cl_error(error, "no kernel named " + name + " in " + file);
    }
    auto& compiled = compiled_[key + " " + name];
    if (!compiled) compiled = std::make_shared<CompiledKernel>(CompiledKernel{read_parameters(kernel), {}});
    return Launch(device_, std::move(kernel), name, compiled);
}

/// The defines that the text of the program names: scenes that differ in others share its kernels.
const Defines& ProgramCache::used(const std::string& file, const Defines& defines) {
    Defines all = defines;
    all.emplace("PENCIL_WIDTH", std::to_string(device_->packet_width()));
    const auto [entry, is_new] = used_.try_emplace(file + " " + build_options(all));
    if (!is_new) return entry->second;
    const std::string source = program_source(file);
    for (const auto& [name, value] : all) {
        bool named = source.find(name) != std::string::npos;
        for (std::size_t at = name.find('_'); at != std::string::npos && !named; at = name.find('_', at + 1))
            named = source.find(name.substr(0, at + 1) + "##") != std::string::npos;  // put together by the preprocessor
        if (named) entry->second.emplace(name, value);
    }
    return entry->second;
}

cl::Program ProgramCache::build(const std::string& file, const Defines& defines) {
    const std::string source = prelude + program_source(file);
    const std::string folder = environment("PENCIL_DUMP_KERNELS"), options = build_options(defines);
    if (!folder.empty()) dump_source(folder, file, defines, source);
    const std::string key = options + "\n" + source;
    if (const auto known = device_->programs().find(key); known != device_->programs().end()) return known->second;

    const auto start = std::chrono::steady_clock::now();
    const ProgramBinaries::Binary binary = binaries_.find(options, source);
    cl::Program program = build_binary(binary, options);
    if (!program()) {
        program = build_source(file, source, options);
        if (binaries_.is_on()) binaries_.keep(options, source, program_binary(program));
    }
    device_->add_build_seconds(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    return device_->programs().emplace(key, program).first->second;
}

/// No program if there is no binary or the driver does not take it.
cl::Program ProgramCache::build_binary(const ProgramBinaries::Binary& binary, const std::string& options) const {
    if (binary.empty()) return {};
    try {
        cl::Program program(device_->context(), {device_->cl_device()}, cl::Program::Binaries{binary});
        program.build(std::vector<cl::Device>{device_->cl_device()}, options.c_str());
        return program;
    } catch (const cl::Error&) {
        return {};
    }
}

cl::Program ProgramCache::build_source(const std::string& file, const std::string& source, const std::string& options) const {
    cl::Program program = cl_call([&] { return "creating the program " + file; }, [&] { return cl::Program(device_->context(), source); });
    try {
        program.build(std::vector<cl::Device>{device_->cl_device()}, options.c_str());
    } catch (const cl::Error& error) {
        throw DeviceError("building " + file + " failed: " + cl_error_name(error.err()) + "\ndevice: " + device_->info().name + " (" +
                          device_->info().platform + ", driver " + device_->info().driver + ")\noptions: " + options + "\n" +
                          build_log(program, device_->cl_device()));
    }
    return program;
}

std::vector<std::string> ProgramCache::built() const {
    std::vector<std::string> names;
    for (const auto& entry : compiled_) names.push_back(entry.first.substr(entry.first.rfind(' ') + 1));
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

}  // namespace pencil
