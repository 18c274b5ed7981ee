// What is to be measured: points and grids of points from text, and the meters of a scene.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace pencil {

/// Of one measurement, meters included: a film is at most so wide.
constexpr std::size_t most_sensors = 1000000;

struct Sensor {
    std::string name;
    SensorPoint place;
};

/// A plane of points as designers lay them on a desk or a floor: the middles of columns x rows equal cells of the parallelogram at `origin`
/// with the sides u and v; they look to the side of cross(u, v).
struct SensorGrid {
    glm::dvec3 origin{0.0}, u{1.0, 0.0, 0.0}, v{0.0, 1.0, 0.0};
    int columns = 1, rows = 1;
};

/// "ox,oy,oz;ux,uy,uz;vx,vy,vz;columns;rows". std::invalid_argument, to complete "--grid: ".
SensorGrid parse_grid(const std::string& text);

/// Row by row.
std::vector<SensorPoint> grid_points(const SensorGrid& grid);

/// Lines "x,y,z,nx,ny,nz" and "grid,ox,oy,oz,ux,uy,uz,vx,vy,vz,columns,rows", separated by commas or blanks; # begins a comment, and the first
/// line may hold names. SceneError that names file and line.
std::vector<SensorPoint> read_sensor_points(const std::filesystem::path& file);

/// The points, numbered from 1 on, then the meters of the scene by their names, "meter 1" where a name is a number. SceneError if one measures a shape that is not there.
std::vector<Sensor> all_sensors(const std::vector<SensorPoint>& points, const Scene& scene);

}  // namespace pencil
