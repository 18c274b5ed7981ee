// What a reader has to say about a scene: collected, so that a user learns all of it at once.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "util/error.h"

namespace pencil {

class Problems {
public:
    /// `strict`: what could only be approximated is an error.
    explicit Problems(bool strict = false) : strict_(strict) {}

    /// Read as meant, and yet worth a word. `where` is "file:line".
    void warn(const std::string& where, const std::string& message);
    /// Not supported; the message says what is done instead.
    void approximate(const std::string& where, const std::string& message);
    void error(const SceneError& error);

    /// Runs `read`, whose SceneError becomes one of the errors; true if there was none.
    template <class Read>
    bool attempt(const Read& read) {
        try {
            read();
            return true;
        } catch (const SceneError& problem) {
            error(problem);
            return false;
        }
    }

    bool has_errors() const { return !errors_.empty(); }
    /// True if there are so many errors that no more will be told, but counted.
    bool is_full() const { return untold_errors_ > 0; }
    /// SceneErrors if there are errors.
    void throw_errors() const;
    /// All warnings; of those that differ in names and numbers only, a few and their count.
    std::vector<std::string> warnings() const;

private:
    void add_error(const std::string& text);

    /// Warnings that differ in names and numbers only.
    struct Kind {
        std::size_t count = 0, last = 0;  // last: index of the last one that is kept
    };

    bool strict_;
    std::map<std::string, Kind> kinds_;
    std::set<std::string> told_;                  // those of warnings_
    std::vector<std::string> warnings_, errors_;  // as many as are told
    std::size_t untold_errors_ = 0;
};

/// The message of an error without the place that it begins with, if that is `where`.
std::string without_place(const SceneError& error, const std::string& where);

}  // namespace pencil
