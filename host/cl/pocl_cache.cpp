// Where PoCL would put its cache, whether it could, and where it goes otherwise.
#include "cl/pocl_cache.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <string>

#include "util/environment.h"
#include "util/log.h"

namespace pencil {
namespace {

namespace fs = std::filesystem;

// PoCL's own rule (using.rst): an empty variable counts as unset; without HOME it takes /tmp/pocl.
fs::path default_cache() {
    const std::string xdg = environment("XDG_CACHE_HOME"), home = environment("HOME");
    if (!xdg.empty()) return fs::path(xdg) / "pocl" / "kcache";
    if (!home.empty()) return fs::path(home) / ".cache" / "pocl" / "kcache";
    return "/tmp/pocl/kcache";
}

// Making the directory is the only sure test: root passes access() in /proc, and a read-only mount has ordinary modes.
bool can_hold_cache(const fs::path& directory) {
    std::error_code error;
    fs::create_directories(directory, error);
    return !error && access(directory.c_str(), W_OK | X_OK) == 0;
}

// PoCL loads code from its cache, so the directory must be ours alone; a name in a shared directory may have been taken by another user.
std::string private_directory() {
    std::error_code error;
    const fs::path temporary = fs::temp_directory_path(error);
    if (error) return "";
    std::string wanted = (temporary / ("pencil-pocl-cache-" + std::to_string(geteuid()))).string();
    mkdir(wanted.c_str(), 0700);
    struct stat status {};
    if (lstat(wanted.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == geteuid() && (status.st_mode & 077) == 0)
        return wanted;
    std::string unique = wanted + "-XXXXXX";
    return mkdtemp(unique.data()) ? unique : "";
}

}  // namespace

std::filesystem::path pocl_cache() {
    const std::string chosen = environment("POCL_CACHE_DIR");
    return chosen.empty() ? default_cache() : fs::path(chosen);
}

void prepare_pocl_cache() {
    static std::once_flag once;
    std::call_once(once, [] {
        // An empty POCL_CACHE_DIR makes PoCL 3.1 abort.
        if (!environment("POCL_CACHE_DIR").empty()) return;
        unsetenv("POCL_CACHE_DIR");
        const fs::path usual = default_cache();
        if (can_hold_cache(usual)) return;
        const std::string instead = private_directory();
        if (instead.empty()) {
            log_warning("neither " + usual.string() +
                        " nor the temporary directory is writable: PoCL, if used, will show no device. Set POCL_CACHE_DIR");
            return;
        }
        setenv("POCL_CACHE_DIR", instead.c_str(), 0);
        log_info("PoCL's cache directory " + usual.string() + " cannot be written; using POCL_CACHE_DIR=" + instead);
    });
}

}  // namespace pencil
