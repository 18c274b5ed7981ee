// Plain POSIX calls: each of them can fail on a full disk, close included, and each failure has to reach the exit status.
#include "util/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "util/error.h"

namespace pencil {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, int error) {
    throw OutputError("cannot write " + path.string() + ": " + std::strerror(error));
}

/// A file that goes away with this object unless `rename_to` succeeded.
class TemporaryFile {
public:
    TemporaryFile(const fs::path& folder, const fs::path& wanted, mode_t mode = 0666) : wanted_(wanted) {
        const int attempts = 100;  // leftovers of killed processes with our process id
        for (int i = 0; i < attempts && descriptor_ < 0; ++i) {
            path_ = folder / (fmt::format(".pencil-{}-{}.tmp", ::getpid(), i));
            descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
            if (descriptor_ < 0 && errno != EEXIST) fail(wanted_, errno);
        }
        if (descriptor_ < 0) fail(wanted_, EEXIST);
    }
    ~TemporaryFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
        if (!path_.empty()) ::unlink(path_.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    void write(const void* data, std::size_t bytes) {
        const char* next = static_cast<const char*>(data);
        while (bytes > 0) {
            const std::size_t most = std::size_t{1} << 30;  // Linux writes at most 2 GiB in one call
            const ::ssize_t written = ::write(descriptor_, next, std::min(bytes, most));
            if (written < 0 && errno != EINTR) fail(wanted_, errno);
            if (written > 0) {
                next += written;
                bytes -= static_cast<std::size_t>(written);
            }
        }
    }

    /// On the disk before it has the name: after a loss of power there is the old file or the new one, not an empty one.
    void rename_to(const fs::path& target) {
        const bool kept = ::fsync(descriptor_) == 0 || errno == EINVAL || errno == ENOTSUP;  // file systems without
        if (!kept) fail(wanted_, errno);
        const int closed = ::close(descriptor_);
        descriptor_ = -1;
        if (closed != 0 || ::rename(path_.c_str(), target.c_str()) != 0) fail(wanted_, errno);
        path_.clear();
    }

private:
    fs::path wanted_, path_;
    int descriptor_ = -1;
};

/// What a rename has to replace so that a symbolic link stays one.
fs::path resolve(const fs::path& path) {
    std::error_code absent, error;
    if (!fs::is_symlink(path, absent)) return path;
    fs::path target = fs::weakly_canonical(path, error);
    if (error) throw OutputError("cannot write " + path.string() + ": " + error.message());
    return target;
}

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

}  // namespace

void check_writable(const fs::path& path) {
    const fs::path target = resolve(path);
    std::error_code error;
    const fs::file_status folder = fs::status(folder_of(target), error);
    if (!fs::exists(folder))
        throw OutputError("cannot write " + path.string() + ": the folder " + folder_of(target).string() + " does not exist");
    if (!fs::is_directory(folder))
        throw OutputError("cannot write " + path.string() + ": " + folder_of(target).string() + " is not a folder");
    const fs::file_status old = fs::status(target, error);
    if (fs::exists(old) && !fs::is_regular_file(old))
        throw OutputError("cannot write " + path.string() + ": it exists and is not a regular file");
    TemporaryFile(folder_of(target), path);
}

namespace {

void write_file(const fs::path& path, const void* data, std::size_t bytes, mode_t mode) {
    const fs::path target = resolve(path);
    TemporaryFile file(folder_of(target), path, mode);
    file.write(data, bytes);
    file.rename_to(target);
}

}  // namespace

void write_file(const fs::path& path, const void* data, std::size_t bytes) { write_file(path, data, bytes, 0666); }

void write_private_file(const fs::path& path, const void* data, std::size_t bytes) { write_file(path, data, bytes, 0600); }

}  // namespace pencil
