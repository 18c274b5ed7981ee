// A file holds the identity of the program, whole, then the binary, then a hash of both: another program, another driver or a damaged file are
// no binary, and the program is built from its text.
#include "cl/program_binaries.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "cl/pocl_cache.h"
#include "util/archive.h"
#include "util/environment.h"
#include "util/error.h"
#include "util/fingerprint.h"
#include "util/output_file.h"

namespace pencil {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t files_kept = 200, hash_digits = 16;

bool keeps_its_own(const DeviceInfo& device) { return device.platform == pocl_platform || device.platform == "NVIDIA CUDA"; }

bool is_ours(const struct stat& status) { return status.st_uid == geteuid() && (status.st_mode & 022) == 0; }

bool is_our_folder(const fs::path& folder) {
    struct stat status {};
    return lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && is_ours(status);
}

// Code is loaded from it: it must be ours alone, and so must the folder that holds it.
fs::path private_folder() {
    fs::path cache = environment("XDG_CACHE_HOME");
    const std::string home = environment("HOME");
    if (!cache.is_absolute()) cache = home.empty() ? fs::path() : fs::path(home) / ".cache";
    if (!cache.is_absolute()) return {};
    std::error_code error;
    fs::create_directories(cache, error);
    const fs::path parent = cache / "pencil", folder = parent / "programs";
    mkdir(parent.c_str(), 0700);
    mkdir(folder.c_str(), 0700);
    return is_our_folder(parent) && is_our_folder(folder) ? folder : fs::path();
}

/// Of a file that is ours alone, else nothing.
std::vector<char> read_ours(const fs::path& path) {
    const int file = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
    if (file < 0) return {};
    struct stat status {};
    std::vector<char> bytes;
    if (fstat(file, &status) == 0 && S_ISREG(status.st_mode) && is_ours(status)) {
        bytes.resize(static_cast<std::size_t>(status.st_size));
        std::size_t got = 0;
        for (ssize_t more = 1; more > 0 && got < bytes.size(); got += static_cast<std::size_t>(std::max<ssize_t>(more, 0)))
            more = read(file, bytes.data() + got, bytes.size() - got);
        bytes.resize(got);
    }
    close(file);
    return bytes;
}

void remove_oldest(const fs::path& folder) {
    std::error_code error;
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        files.emplace_back(entry->last_write_time(error), entry->path());
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
    std::vector<char> bytes = read_ours(path);
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
