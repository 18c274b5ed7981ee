// A file holds the identity of the program, whole, then the binary, then a hash of both: another program, another driver or a damaged file are
// no binary, and the program is built from its text.
#include "cl/program_binaries.h"

#include <algorithm>
#include <system_error>

#include "cl/pocl_cache.h"
#include "cl/private_cache.h"
#include "util/archive.h"
#include "util/environment.h"
#include "util/error.h"
#include "util/fingerprint.h"
#include "util/output_file.h"

namespace pencil {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t files_kept = 200, hash_digits = 16, largest_file = std::size_t{1} << 30;

bool keeps_its_own(const DeviceInfo& device) { return device.platform == pocl_platform || device.platform == "NVIDIA CUDA"; }

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
    if (!keeps_its_own(device) && environment("PENCIL_PROGRAM_CACHE") != "0")
        folder_ = private_cache("programs", true);  // code is loaded from it
}

std::string ProgramBinaries::identity(const std::string& options, const std::string& source) const {
    return device_ + options + '\n' + source;
}

fs::path ProgramBinaries::file(const std::string& identity) const { return folder_ / fingerprint(identity.data(), identity.size()); }

ProgramBinaries::Binary ProgramBinaries::find(const std::string& options, const std::string& source) const {
    if (!is_on()) return {};
    const std::string wanted = identity(options, source);
    const fs::path path = file(wanted);
    std::vector<char> bytes = read_private(path, largest_file);
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
        write_private_file(file(named), bytes.data(), bytes.size());
        remove_oldest(folder_);
    } catch (const OutputError&) {
        // A full disk costs the next start its time, not this render its image.
    }
}

}  // namespace pencil
