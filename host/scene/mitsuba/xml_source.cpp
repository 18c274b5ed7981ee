// The walk is a loop, not a recursion, and it goes in document order, since a <default> holds from its line onwards (Mitsuba's rule). Only
// included files recurse.
#include "scene/mitsuba/xml_source.h"

#include <algorithm>
#include <cstring>

#include "scene/scene_file.h"
#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr int max_depth = 64;
constexpr std::size_t max_include_depth = 16, max_documents = 1000;
constexpr std::ptrdiff_t max_elements_in_all = 4'000'000;
constexpr int max_attributes = 16;            // of one element
constexpr std::size_t max_parameters = 1000;  // <default> elements and defines

const std::set<std::string> known_elements = {
    "scene",  "integrator", "sensor",    "bsdf",      "shape",     "emitter", "film",      "sampler",    "rfilter", "texture",
    "medium", "phase",      "volume",    "boolean",   "integer",   "float",   "string",    "point",      "vector",  "spectrum",
    "rgb",    "srgb",       "blackbody", "transform", "translate", "rotate",  "scale",     "lookat",     "look_at", "lookAt",
    "matrix", "ref",        "default",   "alias",     "include",   "path",    "animation", "subsurface", "camera",  "luminaire"};
const std::set<std::string> left_out = {"subsurface"};
const std::set<std::string> parameters = {"boolean", "integer", "float", "spectrum", "rgb", "srgb"};

}  // namespace

XmlSource::XmlSource(const std::filesystem::path& file, const LoadOptions& options)
    : problems_(options.strict), search_(file.parent_path(), options.allowed, problems_), parameters_(options.defines) {
    open(file, shown(file));
    for (const std::string& name : parameters_.unused())
        problems_.warn(shown(file), "the scene does not use $" + escaped(name) + ", the given value has no effect");
}

void XmlSource::open(const std::filesystem::path& file, const std::string& blamed) {
    std::error_code error;
    const std::filesystem::path canonical = std::filesystem::weakly_canonical(file, error);
    if (std::find(open_files_.begin(), open_files_.end(), canonical) != open_files_.end())
        throw SceneError(blamed, in_quotes(file.string()) + " includes itself");
    if (open_files_.size() > max_include_depth || documents_.size() >= max_documents)
        throw SceneError(blamed, "too many files are included");
    documents_.push_back(std::make_unique<XmlDocument>(file, blamed));
    const XmlDocument& document = *documents_.back();
    by_key_[document.key()] = &document;
    std::ptrdiff_t elements = 0;
    for (const auto& each : documents_) elements += each->elements();
    if (elements > max_elements_in_all)
        throw SceneError(blamed, "the scene's files have more than " + std::to_string(max_elements_in_all) + " elements");
    if (documents_.size() == 1 && std::strcmp(root().name(), "scene") != 0)
        fail(root(), "the root element is <" + escaped(root().name()) + ">, not <scene>");
    struct Opened {
        std::vector<std::filesystem::path>& files;
        ~Opened() { files.pop_back(); }  // however the reading ends
    } at_end{open_files_};
    open_files_.push_back(canonical);
    read_version(document);
    check_tree(document.root());
}

/// Elements with a defect leave the tree, so that what is left can be read and its defects told, too.
void XmlSource::check_tree(pugi::xml_node top) {
    int depth = 1;
    for (pugi::xml_node node = top; node;) {
        const bool sound = problems_.attempt([&] { check_element(node, depth); });
        if (sound && node.first_child()) {
            node = node.first_child();
            ++depth;
            continue;
        }
        const pugi::xml_node defective = sound ? pugi::xml_node() : node;
        while (node && !node.next_sibling()) {
            node = node == top ? pugi::xml_node() : node.parent();
            if (node == top) node = pugi::xml_node();
            --depth;
        }
        if (node) node = node.next_sibling();
        if (defective && defective == top) problems_.throw_errors();
        if (defective) defective.parent().remove_child(defective);
    }
}

void XmlSource::check_element(pugi::xml_node node, int depth) {
    if (node.type() != pugi::node_element) fail(node.parent(), "unexpected text " + in_quotes(trimmed(node.value())));
    const std::string name = node.name();
    if (known_elements.count(name) == 0) {
        const std::string close = closest_name(name, {known_elements.begin(), known_elements.end()});
        fail(node, "element <" + escaped(name) + "> is not known" + (close.empty() ? "" : "; did you mean <" + close + ">?"));
    }
    if (name == "scene" && node.parent() != node.root()) fail(node, "<scene> may only be the root element");
    if (depth > max_depth) fail(node, "elements are nested more than " + std::to_string(max_depth) + " deep");
    substitute(node);
    read_special(node);
}

/// What stands for something else, and what others may ask for.
void XmlSource::read_special(pugi::xml_node node) {
    const std::string name = node.name();
    if (left_out.count(name) != 0) {
        approximate(node, "element <" + name + "> is not supported: left out");
    } else if (name == "default") {
        if (!node.attribute("name") || *node.attribute("name").value() == '\0') fail(node, "<default> needs a name");
        parameters_.add_default(node.attribute("name").value(), node.attribute("value").value());
        if (parameters_.size() > max_parameters) fail(node, "more than " + std::to_string(max_parameters) + " <default> elements");
    } else if (name == "alias") {
        const pugi::xml_node target = find(node.attribute("id").value(), node);
        if (!ids_.emplace(node.attribute("as").value(), target).second)
            fail(node, "id " + in_quotes(node.attribute("as").value()) + " exists");
    } else if (name == "path") {
        const std::filesystem::path folder = find_file(node.attribute("value").value(), node);
        std::error_code error;
        if (std::filesystem::is_directory(folder, error))
            search_.add_folder(folder);
        else
            warn(node, "<path>: " + in_quotes(folder.string()) + " is no folder: ignored");
    } else if (name == "include") {
        include(node);
    } else if (name != "ref" && node.attribute("id")) {
        register_id(node);
    }
}

void XmlSource::include(pugi::xml_node node) {
    if (!node.attribute("filename")) fail(node, "<include> needs a filename");
    const std::filesystem::path file = find_file(node.attribute("filename").value(), node);
    const std::size_t number = documents_.size();
    open(file, where(node));
    included_[node.hash_value()] = documents_[number]->root();
}

std::vector<pugi::xml_node> XmlSource::children(pugi::xml_node node) const {
    std::vector<pugi::xml_node> result;
    for (const pugi::xml_node child : node.children()) {
        const auto place = included_.find(child.hash_value());
        if (place == included_.end()) {
            result.push_back(child);
        } else if (std::strcmp(place->second.name(), "scene") == 0) {
            const std::vector<pugi::xml_node> inner = children(place->second);
            result.insert(result.end(), inner.begin(), inner.end());
        } else if (place->second) {
            result.push_back(place->second);
        }
    }
    return result;
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
        if (std::strchr(attribute.value(), '$') != nullptr) {
            const XmlParameters::Substitution result = parameters_.substituted(attribute.value());
            if (result.too_long) fail(node, "a value grows beyond " + std::to_string(max_value_bytes) + " bytes by substitution");
            attribute.set_value(result.text.c_str());
            for (const std::string& name : result.undefined) undefined(node, name);
        }
        if (std::strlen(attribute.value()) > max_value_bytes)
            fail(node, "attribute " + in_quotes(attribute.name()) + " is longer than " + std::to_string(max_value_bytes) + " bytes");
    }
}

/// Mitsuba takes these from its command line alone, and scenes are published like that.
void XmlSource::undefined(pugi::xml_node node, const std::string& name) {
    const std::string message =
        in_quotes("$" + name) + " is not defined; give it by -D " + escaped(name) + "=VALUE, or a <default> before it";
    const std::string tag = node.name();
    const bool has_stand_in = parameters.count(tag) != 0 || tag == "integrator" || tag == "sampler" || tag == "rfilter" || tag == "film";
    if (!has_stand_in) fail(node, message);
    undefined_.insert(node.hash_value());
    approximate(node, message + "; until then the default is used");
}

void XmlSource::read_version(const XmlDocument& document) {
    const pugi::xml_node top = document.root();
    const bool is_main = documents_.size() == 1;
    const std::string text = top.attribute("version").value();
    int& version = versions_[document.key()];
    version = is_main ? 3 : versions_[documents_.front()->key()];
    if (text.empty()) {
        if (is_main) warn(top, "<scene> has no version attribute; read as version 3");
        return;
    }
    const std::optional<long long> major = parse_integer(text.substr(0, text.find('.')));
    if (!major || *major < 0) fail(top, "version " + in_quotes(text) + " is not a version number");
    if (*major > 3) warn(top, "version " + in_quotes(text) + " is newer than 3, the newest known");
    version = static_cast<int>(std::min<long long>(*major, 3));
}

int XmlSource::version(pugi::xml_node node) const { return versions_.at(node.root().hash_value()); }

pugi::xml_node XmlSource::find(const std::string& id, pugi::xml_node ref) const {
    const auto place = ids_.find(id);
    if (place != ids_.end()) return place->second;
    std::vector<std::string> names;
    if (!problems_.is_full())  // the search is slow
        for (const auto& entry : ids_) names.push_back(entry.first);
    const std::string close = closest_name(id, names);
    fail(ref, "nothing has the id " + in_quotes(id) + (close.empty() ? "" : "; did you mean " + in_quotes(close) + "?"));
}

pugi::xml_node XmlSource::find_if_there(const std::string& id) const {
    const auto place = ids_.find(id);
    return place != ids_.end() ? place->second : pugi::xml_node();
}

std::filesystem::path XmlSource::find_file(const std::string& name, pugi::xml_node node) const {
    return search_.find(name, document_of(node).file().parent_path(), where(node));
}

std::filesystem::path XmlSource::find_file(const std::string& name, const std::filesystem::path& folder, pugi::xml_node node) const {
    return search_.find(name, folder, where(node));
}

std::optional<std::filesystem::path> XmlSource::find_file_if_there(const std::string& name, pugi::xml_node node) const {
    return search_.find_if_there(name, document_of(node).file().parent_path(), where(node));
}

pugi::xml_node XmlSource::add_document(const std::filesystem::path& file, pugi::xml_node node) {
    documents_.push_back(std::make_unique<XmlDocument>(file));
    const XmlDocument& document = *documents_.back();
    by_key_[document.key()] = &document;
    versions_[document.key()] = version(node);
    return document.root();
}

std::string XmlSource::where(pugi::xml_node node) const { return document_of(node).where(node); }

void XmlSource::fail(pugi::xml_node node, const std::string& message) const { throw SceneError(where(node), message); }

}  // namespace pencil
