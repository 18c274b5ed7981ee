// The $names of a scene: <default> elements, and what the user says instead.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace pencil {

constexpr std::size_t max_value_bytes = 64 * 1024;  // of one attribute, after substitution

class XmlParameters {
public:
    /// `defines` win over later defaults.
    explicit XmlParameters(std::map<std::string, std::string> defines);

    void add_default(const std::string& name, const std::string& value) { values_.emplace(name, value); }
    std::size_t size() const { return values_.size(); }

    struct Substitution {
        std::string text;
        std::vector<std::string> undefined;  // names, which stay in the text
        bool too_long = false;
    };
    /// With every $name replaced.
    Substitution substituted(const std::string& text);
    /// Defines that no text asked for.
    std::vector<std::string> unused() const;

private:
    std::map<std::string, std::string> values_;
    std::map<std::string, bool> used_;  // of the defines
};

}  // namespace pencil
