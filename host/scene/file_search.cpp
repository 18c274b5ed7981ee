// A scene may come from anywhere, so it must not make the program read files elsewhere: paths are judged after links have been followed.
#include "scene/file_search.h"

#include <algorithm>
#include <cctype>

#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace fs = std::filesystem;
namespace {

fs::path or_here(const fs::path& folder) { return folder.empty() ? fs::path(".") : folder; }

/// As written on Windows; drive letters and addresses lead nowhere here.
std::string portable(const std::string& name, const std::string& where) {
    if (name.empty()) throw SceneError(where, "the file name is empty");
    std::string path = name;
    std::replace(path.begin(), path.end(), '\\', '/');
    const bool drive = path.size() > 1 && path[1] == ':' && std::isalpha(static_cast<unsigned char>(path[0])) != 0;
    if (drive || path.find("://") != std::string::npos || path.find('\0') != std::string::npos)
        throw SceneError(where, "file name " + in_quotes(name) + " is refused: give a path relative to the scene");
    return path;
}

[[noreturn]] void refuse(const std::string& name, const fs::path& file, const std::string& where) {
    std::error_code error;
    const fs::path target = fs::weakly_canonical(fs::absolute(file, error), error);
    const fs::path folder = fs::is_directory(target, error) ? target : target.parent_path();
    throw SceneError(where, "file name " + in_quotes(name) +
                                " is refused: it leads outside the scene's folder; to allow it, give --allow " +
                                in_quotes(folder.string()));
}

}  // namespace

FileSearch::FileSearch(const fs::path& folder, const std::vector<fs::path>& allowed) : scene_folder_(folder) {
    std::vector<fs::path> folders{or_here(folder)};
    folders.insert(folders.end(), allowed.begin(), allowed.end());
    for (const fs::path& root : folders) {
        std::error_code error;
        const fs::path canonical = fs::canonical(or_here(root), error);
        if (error) throw SceneError(escaped(root.string(), 200), "cannot open the folder: " + error.message());
        roots_.push_back(canonical);
    }
}

bool FileSearch::is_allowed(const fs::path& file) const {
    std::error_code error;
    // From a canonical folder on, so that a file that does not exist is still an absolute path.
    const fs::path target = fs::weakly_canonical(fs::absolute(file, error), error);
    if (error) return false;
    return std::any_of(roots_.begin(), roots_.end(), [&](const fs::path& root) {
        return std::mismatch(root.begin(), root.end(), target.begin(), target.end()).first == root.end();
    });
}

fs::path FileSearch::find(const std::string& name, const fs::path& holder, const std::string& where) const {
    const fs::path path(portable(name, where));
    std::vector<fs::path> candidates{holder / path};  // an absolute path replaces the folder
    for (const fs::path& folder : folders_) candidates.push_back(folder / path);
    candidates.push_back(scene_folder_ / path);
    const fs::path* found = nullptr;
    const fs::path* outside = nullptr;
    for (const fs::path& candidate : candidates) {
        std::error_code error;
        if (!is_allowed(candidate)) {
            if (!outside || fs::exists(candidate, error)) outside = &candidate;
        } else if (fs::exists(candidate, error)) {
            return candidate;
        } else if (!found) {
            found = &candidate;
        }
    }
    if (outside) refuse(name, *outside, where);
    return *found;
}

}  // namespace pencil
