#include "cl/private_cache.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "util/environment.h"

namespace pencil {
namespace {

namespace fs = std::filesystem;

bool is_ours(const struct stat& status) { return status.st_uid == geteuid() && (status.st_mode & 022) == 0; }

bool is_our_folder(const fs::path& folder) {
    struct stat status {};
    return lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && is_ours(status);
}

}  // namespace

fs::path private_cache(const std::string& name, bool make) {
    fs::path cache = environment("XDG_CACHE_HOME");
    const std::string home = environment("HOME");
    if (!cache.is_absolute()) cache = home.empty() ? fs::path() : fs::path(home) / ".cache";
    if (!cache.is_absolute()) return {};
    const fs::path parent = cache / "pencil", folder = parent / name;
    if (make) {
        std::error_code error;
        fs::create_directories(cache, error);
        mkdir(parent.c_str(), 0700);
        mkdir(folder.c_str(), 0700);
    }
    return is_our_folder(parent) && is_our_folder(folder) ? folder : fs::path();
}

std::vector<char> read_private(const fs::path& path, std::size_t most) {
    const int file = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) return {};
    struct stat status {};
    std::vector<char> bytes;
    if (fstat(file, &status) == 0 && S_ISREG(status.st_mode) && is_ours(status) && static_cast<std::size_t>(status.st_size) <= most) {
        bytes.resize(static_cast<std::size_t>(status.st_size));
        std::size_t got = 0;
        for (ssize_t more = 1; more > 0 && got < bytes.size(); got += static_cast<std::size_t>(std::max<ssize_t>(more, 0)))
            more = read(file, bytes.data() + got, bytes.size() - got);
        bytes.resize(got);
    }
    close(file);
    return bytes;
}

}  // namespace pencil
