// Sorts an element's children into parameters and objects, and checks each parameter's element against the kind asked for.
#include "scene/mitsuba/properties.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace {

const std::set<std::string> object_elements = {"integrator", "sensor", "bsdf",  "shape",  "emitter", "film",   "sampler",  "rfilter",
                                               "texture",    "medium", "phase", "volume", "ref",     "camera", "luminaire"};
const std::set<std::string> parameter_elements = {"boolean",  "integer", "float", "string",    "point",    "vector",
                                                  "spectrum", "rgb",     "srgb",  "transform", "blackbody"};

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }

/// Volume of the unit cube's image relative to its edges: 0 when singular, 1 when the axes stay perpendicular.
double skewness(const glm::dmat4& m) {
    const glm::dvec3 a(m[0]), b(m[1]), c(m[2]);
    const double edges = glm::length(a) * glm::length(b) * glm::length(c);
    return edges > 0.0 ? std::abs(glm::dot(a / glm::length(a), glm::cross(b / glm::length(b), c / glm::length(c)))) : 0.0;
}

constexpr double singular = 1e-12;  // a few orders above the rounding of the determinant

/// True if two directions stay two.
bool keeps_a_plane(const glm::dmat4& m) {
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 a(m[i]), b(m[(i + 1) % 3]);
        const double lengths = glm::length(a) * glm::length(b);
        if (lengths > 0.0 && glm::length(glm::cross(a / glm::length(a), b / glm::length(b))) > singular) return true;
    }
    return false;
}

}  // namespace

bool is_flat(const glm::dmat4& m) { return !(skewness(m) > singular); }

std::string snake_case(const std::string& name) {
    std::string result;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const bool starts_word = i > 0 && is_upper(name[i]) && is_lower(name[i - 1]);
        if (starts_word) result += '_';
        const bool inside_word = i > 0 && is_upper(name[i]) && (starts_word || is_upper(name[i - 1]));
        result += inside_word ? static_cast<char>(name[i] - 'A' + 'a') : name[i];
    }
    return result;
}

Properties::Properties(XmlSource& source, pugi::xml_node node) : source_(source), node_(node) {
    for (const pugi::xml_node child : source.children(node)) {
        const std::string tag = child.name();
        if (tag == "default" || tag == "alias" || tag == "path" || tag == "subsurface") continue;
        if (object_elements.count(tag) != 0) {
            const pugi::xml_node target = tag == "ref" ? source.find(child.attribute("id").value(), child) : child;
            objects_.push_back(
                {target, child, target.name(), target.attribute("type").value(), snake_case(child.attribute("name").value())});
        } else if (parameter_elements.count(tag) != 0) {
            add_parameter(child);
        } else if (tag == "animation") {
            add_first_key(child);
        } else {
            source.fail(child, "<" + tag + "> cannot stand inside " + label());
        }
    }
}

void Properties::add_parameter(pugi::xml_node child) {
    const std::string tag = child.name();
    const std::string name = snake_case(child.attribute("name").value());
    if (name.empty()) source_.fail(child, "<" + tag + "> in " + label() + " needs a name");
    if (source_.is_undefined(child)) return;
    if (tag != "transform" && !child.attribute("type") && child.first_child())
        source_.fail(child.first_child(), "<" + tag + "> cannot contain elements");
    if (parameters_.emplace(name, child).second) return;
    const std::string twice = "parameter " + in_quotes(name) + " is given twice in " + label();
    if (source_.version(child) >= 2) source_.fail(child, twice);
    source_.approximate(child, twice + ": the last counts, as in Mitsuba 0.x");
    parameters_[name] = child;
}

/// Motion stands still at its first moment.
void Properties::add_first_key(pugi::xml_node animation) {
    source_.approximate(animation, label() + ": motion is not supported: the first position is used");
    for (const pugi::xml_node key : animation.children("transform")) {
        parameters_.emplace(snake_case(animation.attribute("name").value()), key);
        return;
    }
}

std::string Properties::label() const { return escaped(node_.name()) + " type " + in_quotes(node_.attribute("type").value()); }

void Properties::fail(const std::string& name, const std::string& message) const {
    const auto place = parameters_.find(name);
    source_.fail(place == parameters_.end() ? node_ : place->second, label() + (name.empty() ? " " : ": ") + message);
}

void Properties::approximate(const std::string& name, const std::string& message) const {
    const auto place = parameters_.find(name);
    source_.approximate(place == parameters_.end() ? node_ : place->second, label() + (name.empty() ? " " : ": ") + message);
}

bool Properties::has_slot(const std::string& name) const {
    return has(name) || std::any_of(
                            objects_.begin(), objects_.end(),
                            [&](const NestedObject& object) { return object.kind == "texture" && object.name == name; });
}

std::vector<NestedObject> Properties::take_objects(const std::string& kind) {
    std::vector<NestedObject> result;
    for (const NestedObject& object : objects_) {
        if (object.kind != kind) continue;
        taken_.insert(object.named_at.hash_value());
        result.push_back(object);
    }
    return result;
}

std::optional<NestedObject> Properties::take_texture(const std::string& name) {
    asked_.insert(name);
    std::optional<NestedObject> result;
    for (const NestedObject& object : objects_) {
        if (object.kind != "texture" || object.name != name) continue;
        if (result || has(name)) source_.fail(object.named_at, "parameter " + in_quotes(name) + " is given twice in " + label());
        taken_.insert(object.named_at.hash_value());
        result = object;
    }
    return result;
}

pugi::xml_node Properties::take(const std::string& name) {
    asked_.insert(name);
    const auto place = parameters_.find(name);
    return place == parameters_.end() ? pugi::xml_node() : place->second;
}

/// `tags`: element names that can give this parameter, separated by blanks, the best first.
pugi::xml_node Properties::take(const std::string& name, const std::string& tags) {
    const pugi::xml_node parameter = take(name);
    if (!parameter) return parameter;
    for (const std::string_view tag : tokens(tags))
        if (tag == parameter.name()) return parameter;
    fail(name, "parameter " + in_quotes(name) + " must be a <" + std::string(tokens(tags)[0]) + ">, not a <" + parameter.name() + ">");
}

std::string Properties::value(pugi::xml_node parameter) const {
    if (!parameter.attribute("value")) source_.fail(parameter, std::string("<") + parameter.name() + "> needs a value");
    return parameter.attribute("value").value();
}

double Properties::number(const std::string& name, double absent) {
    const pugi::xml_node parameter = take(name, "float integer");
    if (!parameter) return absent;
    const std::string text = value(parameter);
    const std::optional<double> result = parse_number(text);
    if (!result) fail(name, "parameter " + in_quotes(name) + ": " + number_defect(text));
    return *result;
}

long long Properties::integer(const std::string& name, long long absent) {
    const pugi::xml_node parameter = take(name, "integer float");
    if (!parameter) return absent;
    const std::string text = value(parameter);
    if (const std::optional<long long> result = parse_integer(text)) return *result;
    constexpr double largest = 1e15;                          // every integer up to there is a double
    const std::optional<double> number = parse_number(text);  // "5.0", as some exporters write
    if (!number || std::abs(*number) > largest || *number != std::floor(*number))
        fail(name, "parameter " + in_quotes(name) + ": " + in_quotes(text) + " is not an integer");
    return static_cast<long long>(*number);
}

bool Properties::boolean(const std::string& name, bool absent) {
    const pugi::xml_node parameter = take(name, "boolean");
    if (!parameter) return absent;
    std::string text(trimmed(value(parameter)));
    for (char& c : text) c = is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c;
    if (text != "true" && text != "false")
        fail(name, "parameter " + in_quotes(name) + ": " + in_quotes(text) + " is neither true nor false");
    return text == "true";
}

std::string Properties::text(const std::string& name, const std::string& absent) {
    const pugi::xml_node parameter = take(name, "string float integer");
    return parameter ? value(parameter) : absent;
}

glm::dvec3 Properties::vector(const std::string& name, glm::dvec3 absent) {
    const pugi::xml_node parameter = take(name, "point vector");
    return parameter ? parse_vector(source_, parameter, 0.0) : absent;
}

glm::vec3 Properties::colour(const std::string& name, glm::vec3 absent, ColourUse use) {
    const pugi::xml_node parameter = take(name);
    return parameter ? parse_colour(source_, parameter, use) : absent;
}

glm::dmat4 Properties::transform(const std::string& name) {
    const pugi::xml_node parameter = take(name, "transform");
    if (!parameter) return glm::dmat4(1.0);
    const glm::dmat4 result = parse_transform(source_, parameter);
    if (is_flat(result)) fail(name, "transform " + in_quotes(name) + " is singular: it flattens space");
    return result;
}

glm::dmat4 Properties::placement(const std::string& name) {
    const pugi::xml_node parameter = take(name, "transform");
    if (!parameter) return glm::dmat4(1.0);
    const glm::dmat4 result = parse_transform(source_, parameter);
    if (!keeps_a_plane(result)) fail(name, "transform " + in_quotes(name) + " leaves a line or a point of the shape; is a scale 0?");
    return result;
}

std::vector<double> Properties::numbers(const std::string& name) {
    std::vector<double> result;
    const std::string all = text(name, "");
    for (const std::string_view token : tokens(all)) {
        const std::optional<double> value = parse_number(token);
        if (!value) fail(name, "parameter " + in_quotes(name) + ": " + number_defect(token));
        result.push_back(*value);
    }
    return result;
}

void Properties::ignore(const std::vector<std::string>& names) { asked_.insert(names.begin(), names.end()); }

void Properties::finish() {
    for (const auto& [name, parameter] : parameters_) {
        if (asked_.count(name) != 0) continue;
        const std::string close = closest_name(name, {asked_.begin(), asked_.end()});
        source_.warn(parameter, label() + " has no parameter " + in_quotes(name) + ": ignored" +
                                    (close.empty() ? "" : "; did you mean " + in_quotes(close) + "?"));
    }
    for (const NestedObject& object : objects_) {
        if (taken_.count(object.named_at.hash_value()) != 0) continue;
        const std::string named = object.name.empty() ? "" : " " + in_quotes(object.name);
        source_.approximate(object.named_at, escaped(object.kind) + " type " + in_quotes(object.type) + named + " inside " + label() +
                                                 " is not supported: left out");
    }
}

}  // namespace pencil
