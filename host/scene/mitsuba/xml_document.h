// One file as a tree of XML elements that know their lines.
#pragma once

#include <cstddef>
#include <filesystem>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace pencil {

class XmlDocument {
public:
    /// SceneError for what is no well-formed XML, or larger than any scene. `blamed`: the line that names the file, or the file itself.
    XmlDocument(const std::filesystem::path& file, const std::string& blamed);
    /// Empty, for objects that another file describes.
    explicit XmlDocument(const std::filesystem::path& file) : file_(file) { tree_.append_child("scene"); }

    const std::filesystem::path& file() const { return file_; }
    pugi::xml_node root() const { return tree_.document_element(); }
    std::size_t key() const { return tree_.hash_value(); }  // of the node's root() for every node of this document
    bool is_of_another_format() const { return line_starts_.empty(); }
    std::ptrdiff_t elements() const { return elements_; }  // at most so many
    /// "file:line", or the file alone where there are no lines.
    std::string where(pugi::xml_node node) const;

private:
    void parse(const std::string& text);
    std::string line_at(std::ptrdiff_t offset) const;

    std::filesystem::path file_;
    pugi::xml_document tree_;
    std::vector<std::ptrdiff_t> line_starts_;
    std::ptrdiff_t elements_ = 0;
};

}  // namespace pencil
