// pugixml expands no entities and follows no external ones; the limits here keep the tree itself small. The walk is a loop, not a
// recursion, and it goes in document order, since a <default> holds from its line onwards (Mitsuba's rule).
#include "scene/mitsuba/xml_source.h"

#include <algorithm>
#include <cstring>
#include <set>

#include "scene/scene_file.h"
#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr int max_depth = 64;
constexpr std::ptrdiff_t max_elements = 1'000'000;
constexpr int max_attributes = 16;                  // of one element
constexpr std::size_t max_parameters = 1000;        // <default> elements and defines
constexpr std::size_t max_value_bytes = 64 * 1024;  // of one attribute, after substitution

const std::set<std::string> known_elements = {
    "scene",     "integrator", "sensor",  "bsdf",    "shape",  "emitter", "film",   "sampler", "rfilter",  "texture", "medium",
    "phase",     "volume",     "boolean", "integer", "float",  "string",  "point",  "vector",  "spectrum", "rgb",     "srgb",
    "transform", "translate",  "rotate",  "scale",   "lookat", "look_at", "lookAt", "matrix",  "ref",      "default", "alias"};
const std::set<std::string> unsupported_elements = {"include", "path", "blackbody", "animation", "subsurface", "color"};

}  // namespace

XmlSource::XmlSource(const std::filesystem::path& file, const std::map<std::string, std::string>& defines) : file_(file) {
    parse(read_regular_file(file, max_xml_bytes, shown(file)));
    check_tree(defines);
}

void XmlSource::parse(const std::string& text) {
    const std::string name = shown(file_);
    if (trimmed(text).empty()) throw SceneError(name, "the file is empty");
    if (text.find('\0') != std::string::npos || !is_utf8(text))
        throw SceneError(name, "this is not UTF-8 text; save the scene as UTF-8 XML");
    line_starts_.push_back(0);
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n') line_starts_.push_back(static_cast<std::ptrdiff_t>(i) + 1);
    if (std::count(text.begin(), text.end(), '<') > max_elements)
        throw SceneError(name, "more than " + std::to_string(max_elements) + " elements; put geometry into OBJ or PLY files");
    const unsigned flags = pugi::parse_default | pugi::parse_doctype;
    const pugi::xml_parse_result result = document_.load_buffer(text.data(), text.size(), flags, pugi::encoding_utf8);
    if (result.status == pugi::status_bad_doctype) throw SceneError(line_at(result.offset), "DOCTYPE is not allowed");
    if (!result) throw SceneError(line_at(result.offset), std::string("this is not well-formed XML: ") + result.description());
    for (const pugi::xml_node node : document_.children()) {
        if (node.type() == pugi::node_doctype) throw SceneError(name, "DOCTYPE is not allowed");
        if (node != root()) fail(node, "only one root element is allowed");
    }
}

void XmlSource::check_tree(const std::map<std::string, std::string>& defines) {
    parameters_ = defines;
    for (const auto& define : defines) used_[define.first] = false;
    if (std::strcmp(root().name(), "scene") != 0) fail(root(), "the root element is <" + escaped(root().name()) + ">, not <scene>");
    int depth = 1;
    for (pugi::xml_node node = root(); node;) {
        check_element(node, depth);
        if (node.first_child()) {
            node = node.first_child();
            ++depth;
            continue;
        }
        while (node && !node.next_sibling()) {
            node = node == root() ? pugi::xml_node() : node.parent();
            if (node == root()) node = pugi::xml_node();
            --depth;
        }
        if (node) node = node.next_sibling();
    }
    read_version();
    for (const auto& [name, used] : used_)
        if (!used) warnings_.push_back(shown(file_) + ": the scene does not use $" + escaped(name) + ", the given value has no effect");
}

void XmlSource::check_element(pugi::xml_node node, int depth) {
    if (node.type() != pugi::node_element) fail(node.parent(), "unexpected text " + in_quotes(trimmed(node.value())));
    const std::string name = node.name();
    if (unsupported_elements.count(name) != 0) fail(node, "element <" + name + "> is not supported");
    if (known_elements.count(name) == 0) {
        const std::string close = closest_name(name, {known_elements.begin(), known_elements.end()});
        fail(node, "element <" + escaped(name) + "> is not known" + (close.empty() ? "" : "; did you mean <" + close + ">?"));
    }
    if (name == "scene" && node != root()) fail(node, "<scene> may only be the root element");
    if (depth > max_depth) fail(node, "elements are nested more than " + std::to_string(max_depth) + " deep");
    substitute(node);
    if (name == "default") {
        if (!node.attribute("name") || *node.attribute("name").value() == '\0') fail(node, "<default> needs a name");
        parameters_.emplace(node.attribute("name").value(), node.attribute("value").value());
        if (parameters_.size() > max_parameters) fail(node, "more than " + std::to_string(max_parameters) + " <default> elements");
    } else if (name == "alias") {
        const pugi::xml_node target = find(node.attribute("id").value(), node);
        if (!ids_.emplace(node.attribute("as").value(), target).second)
            fail(node, "id " + in_quotes(node.attribute("as").value()) + " exists");
    } else if (name != "ref" && node.attribute("id")) {
        register_id(node);
    }
}

void XmlSource::register_id(pugi::xml_node node) {
    const std::string id = node.attribute("id").value();
    const auto [place, is_new] = ids_.emplace(id, node);
    if (!is_new) fail(node, "id " + in_quotes(id) + " is used twice; it was given first at " + where(place->second));
}

void XmlSource::substitute(pugi::xml_node node) {
    std::vector<std::string> seen;
    for (pugi::xml_attribute attribute : node.attributes()) {
        if (std::find(seen.begin(), seen.end(), attribute.name()) != seen.end())
            fail(node, "attribute " + in_quotes(attribute.name()) + " is given twice");
        seen.emplace_back(attribute.name());
        if (seen.size() > max_attributes) fail(node, "more than " + std::to_string(max_attributes) + " attributes");
        const std::string value = attribute.value();
        if (value.find('$') != std::string::npos) attribute.set_value(substituted(node, value).c_str());
        if (std::strlen(attribute.value()) > max_value_bytes)
            fail(node, "attribute " + in_quotes(attribute.name()) + " is longer than " + std::to_string(max_value_bytes) + " bytes");
    }
}

/// The longest parameter name that fits after a $ is taken, so that $res does not eat half of $resx.
std::string XmlSource::substituted(pugi::xml_node node, const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] != '$') {
            result += text[i++];
            continue;
        }
        const std::string* name = nullptr;
        const std::string* value = nullptr;
        for (const auto& [candidate, replacement] : parameters_) {
            if (text.compare(i + 1, candidate.size(), candidate) == 0 && (!name || candidate.size() > name->size())) {
                name = &candidate;
                value = &replacement;
            }
        }
        if (!name || name->empty()) {
            const std::size_t end = text.find_first_of(" ,/$", i + 1);
            fail(node, in_quotes(text.substr(i, end == std::string::npos ? end : end - i)) +
                           " is not defined; add <default name=... value=...> before it");
        }
        used_[*name] = true;
        result += *value;
        if (result.size() > max_value_bytes)
            fail(node, "a value grows beyond " + std::to_string(max_value_bytes) + " bytes by substitution");
        i += 1 + name->size();
    }
    return result;
}

void XmlSource::read_version() {
    const std::string text = root().attribute("version").value();
    if (text.empty()) {
        warn(root(), "<scene> has no version attribute; read as version 3");
        return;
    }
    const std::optional<long long> major = parse_integer(text.substr(0, text.find('.')));
    if (!major || *major < 0) fail(root(), "version " + in_quotes(text) + " is not a version number");
    if (*major > 3) warn(root(), "version " + in_quotes(text) + " is newer than 3, the newest known");
    version_ = static_cast<int>(std::min<long long>(*major, 3));
}

pugi::xml_node XmlSource::find(const std::string& id, pugi::xml_node ref) const {
    const auto place = ids_.find(id);
    if (place != ids_.end()) return place->second;
    std::vector<std::string> names;
    for (const auto& entry : ids_) names.push_back(entry.first);
    const std::string close = closest_name(id, names);
    fail(ref, "nothing has the id " + in_quotes(id) + (close.empty() ? "" : "; did you mean " + in_quotes(close) + "?"));
}

std::string XmlSource::line_at(std::ptrdiff_t offset) const {
    const auto next = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
    return shown(file_) + ":" + std::to_string(next - line_starts_.begin());
}

std::string XmlSource::where(pugi::xml_node node) const { return line_at(std::max<std::ptrdiff_t>(node.offset_debug(), 0)); }

void XmlSource::fail(pugi::xml_node node, const std::string& message) const { throw SceneError(where(node), message); }

void XmlSource::warn(pugi::xml_node node, const std::string& message) { warnings_.push_back(where(node) + ": " + message); }

}  // namespace pencil
