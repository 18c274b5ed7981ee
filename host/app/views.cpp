#include "app/views.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <sstream>

#include "scene/scene_file.h"
#include "scene/text.h"
#include "util/error.h"

namespace pencil {

namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t{16} << 20;  // [bytes]
constexpr std::size_t most_views = 100000;

glm::dvec3 vector_at(const std::vector<double>& numbers, std::size_t first) {
    return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

/// Mitsuba's look-at: +z forward, +x to the left.
glm::dmat4 look_at(const glm::dvec3& origin, const glm::dvec3& target, const glm::dvec3& upward) {
    const glm::dvec3 forward = target - origin, left = glm::cross(upward, forward);
    if (!(glm::length(forward) > 0)) throw std::invalid_argument("a camera cannot look at where it stands");
    if (!(glm::length(left) > 1e-9 * glm::length(upward) * glm::length(forward)))
        throw std::invalid_argument("the upward direction is none, or that of sight; give another after the two places");
    const glm::dvec3 z = glm::normalize(forward), x = glm::normalize(left), y = glm::cross(z, x);
    return {glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(origin, 1)};
}

PerspectiveSensor view_of(const std::vector<double>& numbers, const PerspectiveSensor& sensor) {
    if (numbers.size() != 6 && numbers.size() != 9)
        throw std::invalid_argument(
            fmt::format("{} numbers where 6 or 9 are expected: place, target and upward direction", numbers.size()));
    PerspectiveSensor view = sensor;
    view.to_world =
        look_at(vector_at(numbers, 0), vector_at(numbers, 3), numbers.size() == 9 ? vector_at(numbers, 6) : glm::dvec3(sensor.to_world[1]));
    return view;
}

}  // namespace

std::vector<PerspectiveSensor> read_views(const std::filesystem::path& file, const PerspectiveSensor& sensor) {
    std::istringstream text(read_regular_file(file, largest_file, "views"));
    std::vector<PerspectiveSensor> views;
    std::string line;
    for (std::size_t number = 1; std::getline(text, line); ++number) try {
            const std::vector<double> numbers = coordinates(tokens(std::string_view(line).substr(0, line.find('#'))));
            if (!numbers.empty()) views.push_back(view_of(numbers, sensor));
            if (views.size() > most_views) throw std::invalid_argument(fmt::format("more than {} views", most_views));
        } catch (const std::invalid_argument& error) {
            throw SceneError(fmt::format("{}:{}", shown(file), number), error.what());
        }
    if (views.empty()) throw SceneError(shown(file), "it holds no view: write a line x,y,z,x,y,z for each, place and target");
    return views;
}

}  // namespace pencil
