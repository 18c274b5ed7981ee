// Finding the files that a scene names: in the folders it searches, and only inside the folders that it may read.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pencil {

class Problems;

class FileSearch {
public:
    /// A scene in `folder` may read files inside it and inside `allowed`, after symbolic links have been followed. `problems`, which outlives
    /// this, is told of files that stand in for others.
    FileSearch(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& allowed, Problems& problems);

    /// Names are searched here, too, after the folders added before.
    void add_folder(const std::filesystem::path& folder) { folders_.push_back(folder); }

    /// `name` as the file at `where` in folder `holder` means it: relative to `holder`, to added folders or to the scene's, backslashes being
    /// slashes; the first that exists, else one that differs in case or lies in fewer folders, or else the first. SceneError for a name that
    /// leads outside.
    std::filesystem::path find(const std::string& name, const std::filesystem::path& holder, const std::string& where) const;
    /// The same, or none where find() would give or refuse what does not exist.
    std::optional<std::filesystem::path> find_if_there(const std::string& name, const std::filesystem::path& holder,
                                                       const std::string& where) const;

private:
    std::vector<std::filesystem::path> folders_of(const std::filesystem::path& holder) const;
    std::vector<std::filesystem::path> places_of(const std::filesystem::path& path, const std::filesystem::path& holder) const;
    std::optional<std::filesystem::path> find_there(const std::string& name, const std::filesystem::path& path,
                                                    const std::filesystem::path& holder, const std::vector<std::filesystem::path>& places,
                                                    const std::string& where) const;
    bool is_allowed(const std::filesystem::path& file) const;
    /// Empty if there is none.
    std::filesystem::path stand_in(const std::filesystem::path& path, const std::vector<std::filesystem::path>& folders) const;
    std::filesystem::path alike(std::filesystem::path folder, const std::vector<std::string>& parts) const;

    std::filesystem::path scene_folder_;
    std::vector<std::filesystem::path> roots_, folders_;  // roots: canonical
    Problems* problems_;
};

}  // namespace pencil
