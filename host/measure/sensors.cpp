#include "measure/sensors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "scene/scene_file.h"
#include "scene/text.h"
#include "util/error.h"

namespace pencil {

namespace {

using Numbers = std::vector<double>;

constexpr std::uintmax_t largest_file = std::uintmax_t{256} << 20;  // [bytes]
constexpr std::size_t numbers_of_point = 6, numbers_of_grid = 11;

glm::dvec3 vector_at(const Numbers& numbers, std::size_t first) { return {numbers[first], numbers[first + 1], numbers[first + 2]}; }

int count_of(double number) {
    if (!(number >= 1 && number <= static_cast<double>(most_sensors) && number == std::floor(number)))
        throw std::invalid_argument(fmt::format("a grid has 1 to {} columns and rows, not {}", most_sensors, number));
    return static_cast<int>(number);
}

SensorGrid grid_of(const Numbers& n) {
    const SensorGrid grid{vector_at(n, 0), vector_at(n, 3), vector_at(n, 6), count_of(n[9]), count_of(n[10])};
    if (!(glm::length(glm::cross(grid.u, grid.v)) > 0)) throw std::invalid_argument("the sides of a grid must span a plane");
    if (static_cast<double>(grid.columns) * grid.rows > static_cast<double>(most_sensors))
        throw std::invalid_argument(fmt::format("a grid of {} x {} has more than {} points", grid.columns, grid.rows, most_sensors));
    return grid;
}

SensorPoint point_of(const Numbers& n) {
    const glm::dvec3 normal = vector_at(n, 3);
    if (!(glm::length(normal) > 0)) throw std::invalid_argument("the normal nx,ny,nz must not be zero");
    SensorPoint point;
    point.position = vector_at(n, 0);
    point.normal = glm::normalize(normal);
    return point;
}

/// The points of one line. std::invalid_argument.
std::vector<SensorPoint> points_of_line(std::vector<std::string_view> words) {
    const bool grid = words.front() == "grid";
    if (grid) words.erase(words.begin());
    const Numbers numbers = coordinates(words);
    if (numbers.size() != (grid ? numbers_of_grid : numbers_of_point))
        throw std::invalid_argument(fmt::format("{} numbers where {} are expected: {}", numbers.size(),
                                                grid ? numbers_of_grid : numbers_of_point,
                                                grid ? "grid ox,oy,oz,ux,uy,uz,vx,vy,vz,columns,rows" : "x,y,z,nx,ny,nz"));
    return grid ? grid_points(grid_of(numbers)) : std::vector<SensorPoint>{point_of(numbers)};
}

/// Names of columns, one for each number of a point: words that begin with a letter, in quotes or not.
bool is_header(const std::vector<std::string_view>& words) {
    if (words.size() != numbers_of_point || words.front() == "grid") return false;
    return std::all_of(words.begin(), words.end(), [](std::string_view word) {
        if (word.size() > 2 && word.front() == '"') word.remove_prefix(1);
        return std::isalpha(static_cast<unsigned char>(word.front())) != 0 && !parse_number(word);
    });
}

/// Bytes before the text: spreadsheets write a mark that says UTF-8.
std::size_t byte_order_mark(std::string_view text) { return text.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0; }

/// Between semicolons.
std::vector<std::string_view> parts_of(std::string_view text) {
    std::vector<std::string_view> parts;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(';', start), text.size());
        parts.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    return parts;
}

/// tokens() of a text in which commas stand between words only. std::invalid_argument for a comma with nothing on one side.
std::vector<std::string_view> fields_of(std::string_view text) {
    const std::string_view line = trimmed(text);
    for (std::size_t start = 0; !line.empty() && start <= line.size();) {
        const std::size_t end = std::min(line.find(',', start), line.size());
        if (trimmed(line.substr(start, end - start)).empty())
            throw std::invalid_argument(in_quotes(line) + ": a field between commas is empty");
        start = end + 1;
    }
    return tokens(line);
}

/// Whether the words are as many as the parts of a grid have numbers.
bool has_numbers_of_grid(const std::vector<std::string_view>& parts) {
    constexpr std::array<std::size_t, 5> counts{3, 3, 3, 1, 1};
    return std::equal(parts.begin(), parts.end(), counts.begin(), counts.end(),
                      [](std::string_view part, std::size_t count) { return fields_of(part).size() == count; });
}

}  // namespace

SensorGrid parse_grid(const std::string& text) {
    const std::vector<std::string_view> parts = parts_of(text);
    if (!has_numbers_of_grid(parts))
        throw std::invalid_argument(in_quotes(text) + " is not origin;u;v;columns;rows, as in \"0,0,0.8;4,0,0;0,3,0;8;6\"");
    Numbers numbers;
    for (const std::string_view part : parts)
        for (const double number : coordinates(fields_of(part))) numbers.push_back(number);
    return grid_of(numbers);
}

std::vector<SensorPoint> grid_points(const SensorGrid& grid) {
    std::vector<SensorPoint> points;
    SensorPoint point;
    point.normal = glm::normalize(glm::cross(grid.u, grid.v));
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            point.position = grid.origin + (column + 0.5) / grid.columns * grid.u + (row + 0.5) / grid.rows * grid.v;
            points.push_back(point);
        }
    return points;
}

std::vector<SensorPoint> read_sensor_points(const std::filesystem::path& file) {
    const std::string text = read_regular_file(file, largest_file, "points"), name = shown(file);
    std::vector<SensorPoint> points;
    std::size_t line = 0;
    bool begun = false;
    for (std::size_t start = byte_order_mark(text); start < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::string_view whole = std::string_view(text).substr(start, end - start);
        start = end + 1;
        try {
            const std::vector<std::string_view> words = fields_of(whole.substr(0, whole.find('#')));
            const bool header = !begun && is_header(words);
            begun = begun || !words.empty();
            if (words.empty() || header) continue;
            const std::vector<SensorPoint> more = points_of_line(words);
            points.insert(points.end(), more.begin(), more.end());
        } catch (const std::invalid_argument& error) {
            throw SceneError(fmt::format("{}:{}", name, line + 1), error.what());
        }
        if (points.size() > most_sensors)
            throw SceneError(fmt::format("{}:{}", name, line + 1), fmt::format("more than {} points", most_sensors));
    }
    if (points.empty()) throw SceneError(name, "holds no point; lines are x,y,z,nx,ny,nz");
    return points;
}

std::vector<Sensor> all_sensors(const std::vector<SensorPoint>& points, const Scene& scene) {
    std::vector<Sensor> sensors;
    sensors.reserve(points.size());
    for (const SensorPoint& point : points) sensors.push_back({std::to_string(sensors.size() + 1), point});
    for (const IrradianceMeter& meter : scene.meters) {
        if (scene.shapes[meter.shape].triangle_count == 0)
            throw SceneError(scene.file, "irradiance meter " + in_quotes(meter.id) + " measures a shape without triangles");
        SensorPoint place;
        place.shape = meter.shape;
        sensors.push_back({parse_number(meter.id) ? "meter " + meter.id : meter.id, place});
    }
    return sensors;
}

}  // namespace pencil
