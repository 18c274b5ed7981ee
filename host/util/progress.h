// Shows how far a long job is: a bar with the expected remaining time on a terminal, elsewhere a line for each stage's first time and
// one when nothing was said for long, or nothing.
#pragma once

#include <chrono>
#include <cstdio>
#include <set>
#include <string>

namespace pencil {

class ProgressDisplay {
public:
    enum class Style { bar, lines, none };

    /// Bar if `stream` is a terminal, lines if not.
    static Style style_for(std::FILE* stream);

    explicit ProgressDisplay(Style style, std::FILE* stream = stderr) : style_(style), stream_(stream) {}
    ~ProgressDisplay() { clear(); }
    ProgressDisplay(const ProgressDisplay&) = delete;
    ProgressDisplay& operator=(const ProgressDisplay&) = delete;

    /// `fraction` in [0, 1] of the whole job; if it falls when the stage changes, it is taken as that of the stage.
    void update(const std::string& stage, double fraction);
    /// Removes the bar, so that other text can be printed.
    void clear();

private:
    using Clock = std::chrono::steady_clock;
    void print_line(const std::string& stage, double fraction, Clock::time_point now);
    void draw(const std::string& stage, double fraction, Clock::time_point now);

    Style style_;
    std::FILE* stream_;
    std::string stage_;
    std::set<std::string> seen_;
    double first_fraction_ = 0, fraction_ = 0;  // the estimate counts from the first one
    Clock::time_point start_ = Clock::now(), shown_{};
    bool visible_ = false;
};

/// "0:07", "12:40", "3:05:00" of seconds.
std::string format_duration(double seconds);

}  // namespace pencil
