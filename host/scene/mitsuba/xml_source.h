// One scene file as a checked XML tree: known elements only, $names replaced, ids found, every node able to say its line.
#pragma once

#include <filesystem>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <vector>

namespace pencil {

class XmlSource {
public:
    /// Reads and checks the file. `defines` win over <default>.
    XmlSource(const std::filesystem::path& file, const std::map<std::string, std::string>& defines);

    pugi::xml_node root() const { return document_.document_element(); }
    const std::filesystem::path& file() const { return file_; }
    /// Major number of the scene's version attribute: 0.x files spell and mean some parameters differently.
    int version() const { return version_; }
    /// The object with this id; `ref` is blamed if there is none.
    pugi::xml_node find(const std::string& id, pugi::xml_node ref) const;

    std::string where(pugi::xml_node node) const;  // "file:line"
    [[noreturn]] void fail(pugi::xml_node node, const std::string& message) const;
    void warn(pugi::xml_node node, const std::string& message);
    const std::vector<std::string>& warnings() const { return warnings_; }

private:
    std::string line_at(std::ptrdiff_t offset) const;
    void parse(const std::string& text);
    void check_tree(const std::map<std::string, std::string>& defines);
    void check_element(pugi::xml_node node, int depth);
    void substitute(pugi::xml_node node);
    std::string substituted(pugi::xml_node node, const std::string& text);
    void register_id(pugi::xml_node node);
    void read_version();

    std::filesystem::path file_;
    pugi::xml_document document_;
    std::vector<std::ptrdiff_t> line_starts_;
    std::map<std::string, std::string> parameters_;  // of <default> and the defines
    std::map<std::string, bool> used_;
    std::map<std::string, pugi::xml_node> ids_;
    std::vector<std::string> warnings_;
    int version_ = 3;
};

}  // namespace pencil
