// A scene may come from anywhere, so it must not make the program read files elsewhere: paths are judged after links have been followed.
#include "scene/file_search.h"

#include <algorithm>
#include <cctype>

#include "scene/problems.h"
#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace fs = std::filesystem;
namespace {

fs::path or_here(const fs::path& folder) { return folder.empty() ? fs::path(".") : folder; }

constexpr std::size_t most_parts = 16;       // of a path that are tried
constexpr std::size_t most_entries = 20000;  // of a folder that are looked at

[[noreturn]] void refuse(const std::string& name, const std::string& where) {
    throw SceneError(where, "file name " + in_quotes(name) + " is refused: give a path relative to the scene");
}

/// As written on Windows; addresses lead nowhere here.
std::string portable(const std::string& name, const std::string& where) {
    if (name.empty()) throw SceneError(where, "the file name is empty");
    std::string path = name;
    std::replace(path.begin(), path.end(), '\\', '/');
    if (path.find("://") != std::string::npos || path.find('\0') != std::string::npos) refuse(name, where);
    return path;
}

bool has_drive(const std::string& path) {
    return path.size() > 1 && path[1] == ':' && std::isalpha(static_cast<unsigned char>(path[0])) != 0;
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// What a path descends by.
std::vector<std::string> parts_of(const fs::path& path) {
    std::vector<std::string> parts;
    for (const fs::path& part : path) {
        const std::string name = part.string();
        if (name == "..")
            parts.clear();
        else if (!name.empty() && name != "." && name != "/")
            parts.push_back(name);
    }
    if (parts.size() > most_parts) parts.erase(parts.begin(), parts.end() - most_parts);
    return parts;
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

FileSearch::FileSearch(const fs::path& folder, const std::vector<fs::path>& allowed, Problems& problems)
    : scene_folder_(folder), problems_(&problems) {
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
    const std::vector<fs::path> places = places_of(path, holder);
    if (std::optional<fs::path> there = find_there(name, path, holder, places, where)) return *there;
    const auto inside = std::find_if(
        places.begin(), places.end(), [&](const fs::path& place) { return is_allowed(place); });
    const auto outside = std::find_if(places.begin(), places.end(), [&](const fs::path& place) { return !is_allowed(place); });
    if (outside != places.end()) refuse(name, *outside, where);
    if (inside == places.end()) refuse(name, where);
    return *inside;
}

std::optional<fs::path> FileSearch::find_if_there(const std::string& name, const fs::path& holder, const std::string& where) const {
    const fs::path path(portable(name, where));
    return find_there(name, path, holder, places_of(path, holder), where);
}

std::vector<fs::path> FileSearch::folders_of(const fs::path& holder) const {
    std::vector<fs::path> folders{holder};
    folders.insert(folders.end(), folders_.begin(), folders_.end());
    folders.push_back(scene_folder_);
    return folders;
}

/// What the name may mean.
std::vector<fs::path> FileSearch::places_of(const fs::path& path, const fs::path& holder) const {
    std::vector<fs::path> places;
    if (has_drive(path.string())) return places;
    for (const fs::path& folder : folders_of(holder)) places.push_back(folder / path);  // an absolute path replaces the folder
    return places;
}

/// What exists outside is meant, and may be allowed: nothing stands in for it.
std::optional<fs::path> FileSearch::find_there(const std::string& name, const fs::path& path, const fs::path& holder,
                                               const std::vector<fs::path>& places, const std::string& where) const {
    std::error_code error;
    const fs::path* outside = nullptr;
    for (const fs::path& place : places) {
        if (!fs::exists(place, error)) continue;
        if (is_allowed(place)) return place;
        outside = &place;
    }
    if (outside) refuse(name, *outside, where);
    fs::path other = stand_in(path, folders_of(holder));
    if (other.empty()) return std::nullopt;
    problems_->approximate(where, in_quotes(name) + " is not there; " + in_quotes(other.string()) + " is read in its place");
    return other;
}

/// Scenes come from systems where case does not matter, and from folders of other machines: the more of the path fits, the better.
fs::path FileSearch::stand_in(const fs::path& path, const std::vector<fs::path>& folders) const {
    for (std::vector<std::string> parts = parts_of(path); !parts.empty(); parts.erase(parts.begin()))
        for (const fs::path& folder : folders) {
            fs::path found = alike(or_here(folder), parts);
            if (!found.empty()) return found;
        }
    return {};
}

/// The file below `folder` by these names in any case.
fs::path FileSearch::alike(fs::path folder, const std::vector<std::string>& parts) const {
    for (std::size_t i = 0; i < parts.size(); ++i) {
        std::error_code error;
        if (!is_allowed(folder)) return {};
        fs::path next = folder / parts[i];
        if (!fs::exists(next, error)) {
            next.clear();
            const std::string wanted = lower(parts[i]);
            std::size_t looked_at = 0;
            for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error)) {
                if (++looked_at > most_entries) break;
                if (lower(entry->path().filename().string()) == wanted && (next.empty() || entry->path() < next)) next = entry->path();
            }
            if (next.empty()) return {};
        }
        folder = std::move(next);
    }
    std::error_code error;
    return is_allowed(folder) && fs::is_regular_file(folder, error) ? folder : fs::path();
}

}  // namespace pencil
