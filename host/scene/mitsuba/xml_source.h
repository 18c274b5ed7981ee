// A scene file and those that it includes, as checked XML trees: known elements only, $names replaced, ids found, every node able to say its
// line.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <vector>

#include "scene/file_search.h"
#include "scene/load_options.h"
#include "scene/mitsuba/xml_document.h"
#include "scene/mitsuba/xml_parameters.h"
#include "scene/problems.h"

namespace pencil {

class XmlSource {
public:
    /// Reads and checks the files. Elements with defects are taken out of the tree and blamed in problems(); SceneError if nothing is left.
    XmlSource(const std::filesystem::path& file, const LoadOptions& options);

    pugi::xml_node root() const { return documents_.front()->root(); }
    const std::filesystem::path& file() const { return documents_.front()->file(); }
    /// The children, an <include> replaced by what it includes.
    std::vector<pugi::xml_node> children(pugi::xml_node node) const;
    /// Major number of the version of the node's file: 0.x files spell and mean some parameters differently.
    int version(pugi::xml_node node) const;
    /// The object with this id; `ref` is blamed if there is none.
    pugi::xml_node find(const std::string& id, pugi::xml_node ref) const;
    /// The same, or none.
    pugi::xml_node find_if_there(const std::string& id) const;
    /// The file that `node` calls `name`.
    std::filesystem::path find_file(const std::string& name, pugi::xml_node node) const;
    /// The file that one in `folder` calls so; `node` is blamed.
    std::filesystem::path find_file(const std::string& name, const std::filesystem::path& folder, pugi::xml_node node) const;
    /// The same as find_file(name, node), or none if nothing is there.
    std::optional<std::filesystem::path> find_file_if_there(const std::string& name, pugi::xml_node node) const;
    bool is_of_another_format(pugi::xml_node node) const { return document_of(node).is_of_another_format(); }
    /// The top of a tree to which objects can be added that `file` describes in another way, for `node`, whose version they are of.
    pugi::xml_node add_document(const std::filesystem::path& file, pugi::xml_node node);
    /// True if the value of this parameter, or the type of this plugin, holds a $name that nobody gave.
    bool is_undefined(pugi::xml_node node) const { return undefined_.count(node.hash_value()) != 0; }

    Problems& problems() { return problems_; }
    std::string where(pugi::xml_node node) const;  // "file:line"
    [[noreturn]] void fail(pugi::xml_node node, const std::string& message) const;
    void warn(pugi::xml_node node, const std::string& message) { problems_.warn(where(node), message); }
    void approximate(pugi::xml_node node, const std::string& message) { problems_.approximate(where(node), message); }

private:
    const XmlDocument& document_of(pugi::xml_node node) const { return *by_key_.at(node.root().hash_value()); }
    void open(const std::filesystem::path& file, const std::string& blamed);
    void check_tree(pugi::xml_node top);
    void check_element(pugi::xml_node node, int depth);
    void include(pugi::xml_node node);
    void read_special(pugi::xml_node node);
    void substitute(pugi::xml_node node);
    void undefined(pugi::xml_node node, const std::string& name);
    void register_id(pugi::xml_node node);
    void read_version(const XmlDocument& document);

    Problems problems_;
    FileSearch search_;
    XmlParameters parameters_;
    std::vector<std::unique_ptr<XmlDocument>> documents_;  // the scene's first
    std::map<std::size_t, const XmlDocument*> by_key_;
    std::map<std::size_t, int> versions_;             // by document
    std::map<std::size_t, pugi::xml_node> included_;  // roots, by <include> element
    std::vector<std::filesystem::path> open_files_;   // those that are being read, canonical
    std::map<std::string, pugi::xml_node> ids_;
    std::set<std::size_t> undefined_;
};

}  // namespace pencil
