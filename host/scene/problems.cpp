#include "scene/problems.h"

#include <algorithm>

namespace pencil {
namespace {

constexpr std::size_t most_errors = 50;    // that are listed
constexpr std::size_t most_of_a_kind = 4;  // warnings

/// The message without what is quoted, and without numbers.
std::string kind_of(const std::string& message) {
    std::string kind;
    bool quoted = false;
    for (const char c : message) {
        if (c == '"') quoted = !quoted;
        if (!quoted && (c < '0' || c > '9')) kind += c;
    }
    return kind;
}

}  // namespace

void Problems::warn(const std::string& where, const std::string& message) {
    const std::string text = where + ": " + message;
    if (told_.count(text) != 0) return;
    Kind& kind = kinds_[kind_of(message)];
    if (++kind.count > most_of_a_kind) return;
    kind.last = warnings_.size();
    warnings_.push_back(text);
    told_.insert(text);
}

void Problems::approximate(const std::string& where, const std::string& message) {
    if (strict_)
        error(SceneError(where, message));
    else
        warn(where, message);
}

void Problems::error(const SceneError& error) {
    const auto* several = dynamic_cast<const SceneErrors*>(&error);
    if (!several) return add_error(error.what());
    for (const std::string& text : several->each) add_error(text);
}

void Problems::add_error(const std::string& text) {
    if (std::find(errors_.begin(), errors_.end(), text) != errors_.end()) return;
    if (errors_.size() < most_errors)
        errors_.push_back(text);
    else
        ++untold_errors_;
}

void Problems::throw_errors() const {
    if (errors_.empty()) return;
    std::vector<std::string> listed = errors_;
    if (untold_errors_ > 0) listed.push_back("and " + std::to_string(untold_errors_) + " more errors");
    throw SceneErrors(listed);
}

std::vector<std::string> Problems::warnings() const {
    std::vector<std::string> result = warnings_;
    for (const auto& entry : kinds_) {
        const Kind& kind = entry.second;
        if (kind.count > most_of_a_kind)
            result[kind.last] += " (and " + std::to_string(kind.count - most_of_a_kind) + " more warnings like this one)";
    }
    return result;
}

std::string without_place(const SceneError& error, const std::string& where) {
    const std::string message = error.what(), place = where + ": ";
    return message.rfind(place, 0) == 0 ? message.substr(place.size()) : message;
}

}  // namespace pencil
