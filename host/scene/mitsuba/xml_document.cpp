// pugixml expands no entities and follows no external ones, nor the file that a DOCTYPE names; the limits here keep the tree itself small.
#include "scene/mitsuba/xml_document.h"

#include <algorithm>

#include "scene/scene_file.h"
#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr std::ptrdiff_t max_elements = 1'000'000;
constexpr const char* no_declarations =
    "a DOCTYPE may only name the kind of document, at its beginning: entities are never expanded; write out what they stand for";

}  // namespace

XmlDocument::XmlDocument(const std::filesystem::path& file, const std::string& blamed) : file_(file) {
    parse(as_utf8(read_regular_file(file, max_xml_bytes, blamed)));
}

void XmlDocument::parse(const std::string& text) {
    const std::string name = shown(file_);
    if (trimmed(text).empty()) throw SceneError(name, "the file is empty");
    if (text.find('\0') != std::string::npos) throw SceneError(name, "this is binary data, not XML");
    line_starts_.push_back(0);
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n') line_starts_.push_back(static_cast<std::ptrdiff_t>(i) + 1);
    elements_ = std::count(text.begin(), text.end(), '<');
    if (elements_ > max_elements)
        throw SceneError(name, "more than " + std::to_string(max_elements) + " elements; put geometry into OBJ or PLY files");
    const unsigned flags = pugi::parse_default | pugi::parse_doctype;
    const pugi::xml_parse_result result = tree_.load_buffer(text.data(), text.size(), flags, pugi::encoding_utf8);
    if (result.status == pugi::status_bad_doctype) throw SceneError(line_at(result.offset), no_declarations);
    if (!result) throw SceneError(line_at(result.offset), std::string("this is not well-formed XML: ") + result.description());
    for (const pugi::xml_node node : tree_.children()) {
        if (node.type() == pugi::node_doctype) {
            if (std::string(node.value()).find('[') != std::string::npos) throw SceneError(name, no_declarations);
        } else if (node != root())
            throw SceneError(where(node), "only one root element is allowed");
    }
}

std::string XmlDocument::line_at(std::ptrdiff_t offset) const {
    const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
    return shown(file_) + ":" + std::to_string(next - line_starts_.begin());
}

std::string XmlDocument::where(pugi::xml_node node) const {
    return line_starts_.empty() ? shown(file_) : line_at(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
}

}  // namespace pencil
