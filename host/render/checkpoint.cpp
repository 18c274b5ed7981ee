// The file: a line that names the format, the size of what follows, the identity and the state as an Archive, and a hash of these.
#include "render/checkpoint.h"

#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "cl/embedded_kernels.h"
#include "options/render_option_table.h"
#include "scene/scene_fingerprint.h"
#include "util/archive.h"
#include "util/environment.h"
#include "util/error.h"
#include "util/fingerprint.h"
#include "util/output_file.h"

namespace pencil {

namespace {

const std::string first_line = "pencil checkpoint 3\n";
constexpr std::size_t hash_digits = 16;
/// Of the time, for checkpoints.
constexpr double share = 0.02;

std::string kernels_fingerprint() {
    std::string texts;
    for (const auto& [name, text] : embedded_kernels()) texts += name + '\n' + text;
    return fingerprint(texts.data(), texts.size());
}

/// Of the running program, whose every change may change an image.
std::string program_fingerprint() {
    std::ifstream file("/proc/self/exe", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    return fingerprint(bytes.data(), bytes.size());
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
    throw UsageError(fmt::format("--resume {}: {}", file.string(), why));
}

std::vector<char> read_bytes(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) refuse(file, "there is no such file");
    if (!std::filesystem::is_regular_file(status)) refuse(file, "it is no regular file");
    std::ifstream in(file, std::ios::binary);
    std::string line(first_line.size(), '\0');
    in.read(line.data(), static_cast<std::streamsize>(line.size()));
    if (line != first_line) refuse(file, in.bad() || !in.is_open() ? "it cannot be read" : "it is no checkpoint of this version of pencil");
    const auto size = std::filesystem::file_size(file, error);
    std::vector<char> bytes(static_cast<std::size_t>(size) - first_line.size());
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (static_cast<std::size_t>(in.gcount()) != bytes.size() || bytes.size() < hash_digits)
        refuse(file, "it is damaged: it ends too early");
    return bytes;
}

}  // namespace

RenderIdentity render_identity(const Scene& scene, const RenderOptions& options, const Device& device) {
    RenderIdentity identity{{"program", program_fingerprint()},
                            {"scene", scene_fingerprint(scene)},
                            {"kernels", kernels_fingerprint()},
                            {"device", device.info().name},
                            {"driver", device.info().driver},
                            {"PENCIL_KERNEL_DIR", environment("PENCIL_KERNEL_DIR")},
                            {"PENCIL_WIDTH", std::to_string(device.packet_width())},
                            {"PENCIL_WIDE_BVH", environment("PENCIL_WIDE_BVH")}};
    RenderOptions shown = options;
    for (const Option& row : render_option_table(shown))
        if (row.flag != "--time" && row.flag != "--target-error") identity.emplace_back(row.flag, spelled(row.show()));
    return identity;
}

void write_checkpoint(const std::filesystem::path& file, const RenderIdentity& identity, const std::vector<char>& state) {
    Archive archive;
    RenderIdentity named = identity;
    std::vector<char> copy = state;
    archive(named, copy);
    const std::vector<char> body = archive.take();
    std::vector<char> bytes(first_line.begin(), first_line.end());
    bytes.insert(bytes.end(), body.begin(), body.end());
    const std::string hash = fingerprint(body.data(), body.size());
    bytes.insert(bytes.end(), hash.begin(), hash.end());
    write_file(file, bytes.data(), bytes.size());
}

std::vector<char> read_checkpoint(const std::filesystem::path& file, const RenderIdentity& identity) {
    std::vector<char> bytes = read_bytes(file);
    const std::string hash(bytes.end() - hash_digits, bytes.end());
    bytes.resize(bytes.size() - hash_digits);
    if (hash != fingerprint(bytes.data(), bytes.size())) refuse(file, "it is damaged: its contents and their hash differ");
    RenderIdentity named;
    std::vector<char> state;
    try {
        Archive archive(std::move(bytes));
        archive(named, state);
    } catch (const ArchiveError& error) {
        refuse(file, std::string("it is damaged: ") + error.what());
    }
    if (named.size() != identity.size()) refuse(file, "it is of another version of pencil");
    for (std::size_t i = 0; i < identity.size(); ++i)
        if (named[i] != identity[i])
            refuse(file, fmt::format("it is of another render: its {} is {}, here {} is {}", named[i].first, named[i].second,
                                     identity[i].first, identity[i].second));
    return state;
}

void CheckpointClock::written_in(double seconds) {
    least_pause_ = seconds / share;
    since_ = Stopwatch();
}

}  // namespace pencil
