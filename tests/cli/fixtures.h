// What the tests of this folder need around the program: a folder, a scene, and another program's view of the images.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pencil_test {

/// A folder of the test's own, removed at its end.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }
    /// The path of a new file with this text.
    std::string write(const std::string& name, const std::string& text) const;
    /// Names of all files, hidden ones too, sorted.
    std::vector<std::string> names() const;

private:
    std::filesystem::path path_;
};

std::string read_text(const std::filesystem::path& file);
std::vector<std::string> lines_of(const std::string& text);

/// A floor under a small lamp: the least scene with direct and indirect light. `lamp` and `floor` can be left out.
std::string small_scene(bool lamp = true, bool floor = true);

/// Options for a render of about a tenth of a second, once the kernels are built.
const std::vector<std::string>& quick();

/// Largest absolute difference over all channels, read by oiiotool, a reader that is not ours. Negative if it cannot compare.
double largest_difference(const std::filesystem::path& a, const std::filesystem::path& b);
/// What `oiiotool --info -v --stats` says.
std::string image_info(const std::filesystem::path& file);

}  // namespace pencil_test
