// The parameters and nested objects of one plugin element. Parameters nobody asked for become warnings, so that none is lost silently.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scene/mitsuba/xml_values.h"

namespace pencil {

struct NestedObject {
    pugi::xml_node node;      // the object itself, references followed
    pugi::xml_node named_at;  // the object or the <ref> to it: the place to blame
    std::string kind;         // element name: bsdf, emitter, film, ...
    std::string type;         // plugin
    std::string name;         // of the parameter that it is, or empty
};

class Properties {
public:
    Properties(XmlSource& source, pugi::xml_node node);

    XmlSource& source() const { return source_; }
    pugi::xml_node node() const { return node_; }
    /// "bsdf type "diffuse"", for messages.
    std::string label() const;
    [[noreturn]] void fail(const std::string& name, const std::string& message) const;  // at the parameter; with no name, at the object

    /// Not supported here; the message says what is done instead.
    void approximate(const std::string& name, const std::string& message) const;

    bool has(const std::string& name) const { return parameters_.count(name) != 0; }
    /// As a value or as a texture.
    bool has_slot(const std::string& name) const;
    /// Element of the parameter, or none; it counts as read.
    pugi::xml_node element(const std::string& name) { return take(name); }
    double number(const std::string& name, double absent);
    long long integer(const std::string& name, long long absent);
    bool boolean(const std::string& name, bool absent);
    std::string text(const std::string& name, const std::string& absent);
    glm::dvec3 vector(const std::string& name, glm::dvec3 absent);
    glm::vec3 colour(const std::string& name, glm::vec3 absent, ColourUse use);
    /// Several numbers of one <string>, separated by blanks or commas; empty if absent.
    std::vector<double> numbers(const std::string& name);
    /// Identity if absent; never singular.
    glm::dmat4 transform(const std::string& name);
    /// The same of a surface, which may be flattened to a plane.
    glm::dmat4 placement(const std::string& name);

    /// Known, and without effect here.
    void ignore(const std::vector<std::string>& names);
    const std::vector<NestedObject>& objects() const { return objects_; }
    /// Nested objects of this kind; from now on they count as read.
    std::vector<NestedObject> take_objects(const std::string& kind);
    /// The nested texture that is this parameter.
    std::optional<NestedObject> take_texture(const std::string& name);
    /// Warns about parameters and objects that were neither asked for nor ignored.
    void finish();

private:
    void add_parameter(pugi::xml_node child);
    void add_first_key(pugi::xml_node animation);
    pugi::xml_node take(const std::string& name);
    pugi::xml_node take(const std::string& name, const std::string& tags);
    std::string value(pugi::xml_node parameter) const;

    XmlSource& source_;
    pugi::xml_node node_;
    std::map<std::string, pugi::xml_node> parameters_;
    std::set<std::string> asked_;
    std::set<std::size_t> taken_;  // objects, by the node that names them
    std::vector<NestedObject> objects_;
};

/// True for what takes space to a plane, or less.
bool is_flat(const glm::dmat4& m);

/// "toWorld" to "to_world": Mitsuba 0.x names to those of 3.x.
std::string snake_case(const std::string& name);

}  // namespace pencil
