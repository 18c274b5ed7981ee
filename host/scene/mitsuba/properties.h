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
};

class Properties {
public:
    Properties(XmlSource& source, pugi::xml_node node);

    XmlSource& source() const { return source_; }
    pugi::xml_node node() const { return node_; }
    /// "bsdf type "diffuse"", for messages.
    std::string label() const;
    [[noreturn]] void fail(const std::string& name, const std::string& message) const;  // at the parameter; with no name, at the object

    bool has(const std::string& name) const { return parameters_.count(name) != 0; }
    double number(const std::string& name, double absent);
    long long integer(const std::string& name, long long absent);
    bool boolean(const std::string& name, bool absent);
    std::string text(const std::string& name, const std::string& absent);
    glm::dvec3 vector(const std::string& name, glm::dvec3 absent);
    glm::vec3 colour(const std::string& name, glm::vec3 absent, ColourUse use);
    /// Identity if absent; never singular.
    glm::dmat4 transform(const std::string& name);

    /// Known, and without effect here.
    void ignore(const std::vector<std::string>& names);
    /// A nested object that has no business here.
    [[noreturn]] void fail_nested(const NestedObject& object) const;
    const std::vector<NestedObject>& objects() const { return objects_; }
    /// Warns about parameters that were neither asked for nor ignored.
    void finish();

private:
    pugi::xml_node take(const std::string& name);
    pugi::xml_node take(const std::string& name, const std::string& tags);
    std::string value(pugi::xml_node parameter) const;

    XmlSource& source_;
    pugi::xml_node node_;
    std::map<std::string, pugi::xml_node> parameters_;
    std::set<std::string> asked_;
    std::vector<NestedObject> objects_;
};

/// "toWorld" to "to_world": Mitsuba 0.x names to those of 3.x.
std::string snake_case(const std::string& name);

}  // namespace pencil
