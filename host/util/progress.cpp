// The bar is redrawn in place at most ten times a second; a terminal narrower than the line only looks untidy.
#include "util/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace pencil {
namespace {

constexpr auto redraw_interval = std::chrono::milliseconds(100);
constexpr auto line_interval = std::chrono::seconds(10);
constexpr int bar_width = 30;           // [characters]
constexpr double earliest_guess = 0.5;  // [s] of work before a remaining time is worth showing

double seconds_between(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

}  // namespace

ProgressDisplay::Style ProgressDisplay::style_for(std::FILE* stream) {
    const char* terminal = std::getenv("TERM");
    const bool dumb = terminal != nullptr && std::string(terminal) == "dumb";
    return ::isatty(::fileno(stream)) != 0 && !dumb ? Style::bar : Style::lines;
}

void ProgressDisplay::update(const std::string& stage, double fraction) {
    if (style_ == Style::none) return;
    fraction = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : fraction_;
    const Clock::time_point now = Clock::now();
    const bool new_stage = stage != stage_;
    if (fraction < fraction_) {
        start_ = now;
        first_fraction_ = fraction;
    }
    fraction_ = fraction;
    stage_ = stage;
    if (style_ == Style::lines)
        print_line(stage, fraction, now);
    else if (new_stage || now - shown_ >= redraw_interval)
        draw(stage, fraction, now);
}

void ProgressDisplay::print_line(const std::string& stage, double fraction, Clock::time_point now) {
    const bool first_time = seen_.insert(stage).second;
    if (first_time)
        std::fprintf(stream_, "pencil: %s\n", stage.c_str());
    else if (now - shown_ >= line_interval)
        std::fprintf(stream_, "pencil: %s, %.0f %%\n", stage.c_str(), 100 * fraction);
    else
        return;
    std::fflush(stream_);
    shown_ = now;
}

void ProgressDisplay::draw(const std::string& stage, double fraction, Clock::time_point now) {
    const int filled = static_cast<int>(std::lround(fraction * bar_width));
    const std::string bar = std::string(filled, '#') + std::string(bar_width - filled, '.');
    const double elapsed = seconds_between(start_, now);
    const double done = fraction - first_fraction_;
    std::string remaining = "?";
    if (elapsed > earliest_guess && done > 0) remaining = format_duration(elapsed * (1 - fraction) / done);
    std::fprintf(stream_, "\r\033[K[%s] %3.0f %%  %s left  %s", bar.c_str(), 100 * fraction, remaining.c_str(), stage.c_str());
    std::fflush(stream_);
    shown_ = now;
    visible_ = true;
}

void ProgressDisplay::clear() {
    if (visible_) {
        std::fputs("\r\033[K", stream_);
        std::fflush(stream_);
        visible_ = false;
    }
}

std::string format_duration(double seconds) {
    const double longest = 359999;  // 99:59:59
    const int total = static_cast<int>(std::lround(std::clamp(seconds, 0.0, longest)));
    char text[32];
    if (total >= 3600)
        std::snprintf(text, sizeof(text), "%d:%02d:%02d", total / 3600, total / 60 % 60, total % 60);
    else
        std::snprintf(text, sizeof(text), "%d:%02d", total / 60, total % 60);
    return text;
}

}  // namespace pencil
