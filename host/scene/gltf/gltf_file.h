// A parsed glTF file with its buffers and the bytes of its images. Indices in it are as the file gives them: follow them by `at`.
#pragma once

#include <tiny_gltf.h>

#include <filesystem>
#include <string>
#include <vector>

#include "scene/file_search.h"
#include "scene/load_options.h"
#include "scene/problems.h"
#include "util/error.h"

namespace pencil {

class GltfFile {
public:
    /// Reads the file and those that it names, all of them inside its folder and those that the options allow. SceneError for what cannot
    /// be parsed, lies elsewhere, is too large or needs an extension that is not supported.
    GltfFile(const std::filesystem::path& file, const LoadOptions& options);

    const tinygltf::Model& model() const { return model_; }
    const std::filesystem::path& path() const { return path_; }

    /// The element of `list` with this index. `what` is the list's name in the singular, `user` the object that names it.
    template <class T>
    const T& at(const std::vector<T>& list, int index, const char* what, const std::string& user) const {
        if (index < 0 || static_cast<std::size_t>(index) >= list.size())
            fail(user + " names " + what + " " + std::to_string(index) + ", but there are " + std::to_string(list.size()));
        return list[static_cast<std::size_t>(index)];
    }

    [[noreturn]] void fail(const std::string& message) const;
    /// Of what is read as meant, and of what is not supported and so left out or replaced.
    void warn(const std::string& message);
    void approximate(const std::string& message);
    /// SceneErrors where nothing may be approximated and something is.
    std::vector<std::string> warnings() const;

private:
    void parse(const std::string& bytes);
    void take_specular_glossiness();
    void check_required_extensions() const;
    void check_extensions();

    std::filesystem::path path_;
    tinygltf::Model model_;
    Problems problems_;
    FileSearch search_;
};

/// "mesh 3 \"chair\"": kind, index and name, safe to print.
std::string named(const char* kind, std::size_t index, const std::string& name);

}  // namespace pencil
