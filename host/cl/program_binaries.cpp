// A file holds the identity of the program, whole, then the binary, then a hash of both: another program, another driver or a damaged file are
// no binary, and the program is built from its text.
#include "cl/program_binaries.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

#include "util/archive.h"
#include "util/environment.h"
#include "util/error.h"
#include "util/fingerprint.h"
#include "util/output_file.h"

namespace pencil {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t files_kept = 200, hash_digits = 16;

bool keeps_its_own(const DeviceInfo& device) {
    return device.platform == "Portable Computing Language" || device.platform == "NVIDIA CUDA";
}

// Code is loaded from it: it must be ours alone.
fs::path private_folder() {
    const std::string xdg = environment("XDG_CACHE_HOME"), home = environment("HOME");
    if (xdg.empty() && home.empty()) return {};
    const fs::path folder = (xdg.empty() ? fs::path(home) / ".cache" : fs::path(xdg)) / "pencil" / "programs";
    std::error_code error;
    fs::create_directories(folder.parent_path(), error);
    mkdir(folder.c_str(), 0700);
    struct stat status {};
    const bool ours =
        lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == geteuid() && (status.st_mode & 022) == 0;
    return ours ? folder : fs::path();
}

void remove_oldest(const fs::path& folder) {
    std::error_code error;
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
        files.emplace_back(entry.last_write_time(error), entry.path());
    std::sort(files.begin(), files.end());
    for (std::size_t i = 0; i + files_kept < files.size(); ++i) fs::remove(files[i].second, error);
}

}  // namespace

ProgramBinaries::ProgramBinaries(const DeviceInfo& device)
    : device_(device.platform + '\n' + device.name + '\n' + device.vendor + '\n' + device.version + '\n' + device.driver + '\n') {
    if (!keeps_its_own(device) && environment("PENCIL_PROGRAM_CACHE") != "0") folder_ = private_folder();
}

std::string ProgramBinaries::identity(const std::string& options, const std::string& source) const {
    return device_ + options + '\n' + source;
}

fs::path ProgramBinaries::file(const std::string& identity) const { return folder_ / fingerprint(identity.data(), identity.size()); }

ProgramBinaries::Binary ProgramBinaries::find(const std::string& options, const std::string& source) const {
    if (!is_on()) return {};
    const std::string wanted = identity(options, source);
    const fs::path path = file(wanted);
    std::ifstream in(path, std::ios::binary);
    std::vector<char> bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (bytes.size() < hash_digits) return {};
    const std::string hash(bytes.end() - hash_digits, bytes.end());
    bytes.resize(bytes.size() - hash_digits);
    if (hash != fingerprint(bytes.data(), bytes.size())) return {};
    try {
        Archive archive(std::move(bytes));
        std::string named;
        Binary binary;
        archive(named, binary);
        if (named != wanted) return {};
        std::error_code error;
        fs::last_write_time(path, fs::file_time_type::clock::now(), error);
        return binary;
    } catch (const ArchiveError&) {
        return {};
    }
}

void ProgramBinaries::keep(const std::string& options, const std::string& source, const Binary& binary) const {
    if (!is_on() || binary.empty()) return;
    std::string named = identity(options, source);
    Binary copy = binary;
    Archive archive;
    archive(named, copy);
    std::vector<char> bytes = archive.take();
    const std::string hash = fingerprint(bytes.data(), bytes.size());
    bytes.insert(bytes.end(), hash.begin(), hash.end());
    try {
        write_file(file(named), bytes.data(), bytes.size());
        remove_oldest(folder_);
    } catch (const OutputError&) {
        // A full disk costs the next start its time, not this render its image.
    }
}

}  // namespace pencil
