// Defaults are Mitsuba's: focal length 50 mm on 36 x 24 mm film when no field of view is given.
#include "scene/mitsuba/read_sensor.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/mitsuba/read_film.h"
#include "scene/text.h"

namespace pencil {
namespace {

/// "50mm" or "50": the focal length for 36 x 24 mm film gives the diagonal field of view.
double fov_of_focal_length(Properties& p) {
    const std::string text = p.text("focal_length", "50mm");
    std::string_view digits = trimmed(text);
    if (digits.size() > 2 && digits.substr(digits.size() - 2) == "mm") digits.remove_suffix(2);
    const std::optional<double> length = parse_number(digits);
    if (!length || !(*length > 0.0))
        p.fail("focal_length", "focal_length " + in_quotes(text) + " must be a positive number of millimetres, as in \"50mm\"");
    return 2.0 * glm::degrees(std::atan(std::hypot(36.0, 24.0) / (2.0 * *length)));
}

/// The field of view along `axis` as the horizontal one.
double horizontal_fov(Properties& p, double fov, std::string axis, double aspect) {
    if (axis == "smaller") axis = aspect > 1.0 ? "y" : "x";
    if (axis == "larger") axis = aspect > 1.0 ? "x" : "y";
    const double half = std::tan(0.5 * glm::radians(fov));
    if (axis == "x") return fov;
    if (axis == "y") return 2.0 * glm::degrees(std::atan(half * aspect));
    if (axis == "diagonal") return 2.0 * glm::degrees(std::atan(half * aspect / std::hypot(aspect, 1.0)));
    p.fail("fov_axis", "fov_axis " + in_quotes(axis) + " must be x, y, diagonal, smaller or larger");
}

double read_fov(Properties& p, double aspect) {
    if (p.has("fov") && p.has("focal_length")) p.fail("focal_length", "give either fov or focal_length, not both");
    const std::string axis = p.text("fov_axis", p.has("fov") ? "x" : "diagonal");
    const double fov = p.has("fov") ? p.number("fov", 0.0) : fov_of_focal_length(p);
    if (!(fov > 0.0 && fov < 180.0)) p.fail("fov", "fov must lie between 0 and 180 degrees, both excluded");
    return horizontal_fov(p, fov, p.has("fov") ? axis : "diagonal", aspect);
}

/// Length is of no meaning to directions, so a uniform scale is taken out; any other is an error as in Mitsuba.
glm::dmat4 read_frame(Properties& p) {
    constexpr double tolerance = 1e-3;  // of exported matrices with few digits
    glm::dmat4 frame = p.transform("to_world");
    const double scale = glm::length(glm::dvec3(frame[0]));
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 axis(frame[i]), next(frame[(i + 1) % 3]);
        if (std::abs(glm::length(axis) / scale - 1.0) > tolerance || std::abs(glm::dot(axis, next)) > tolerance * scale * scale)
            p.fail("to_world", "a sensor's to_world may only rotate, mirror and move");
    }
    if (std::abs(scale - 1.0) > tolerance) p.source().warn(p.node(), p.label() + ": the scale in to_world is left out");
    for (int i = 0; i < 3; ++i) frame[i] = glm::dvec4(glm::normalize(glm::dvec3(frame[i])), 0.0);
    return frame;
}

void read_type(Properties& p, const std::string& type, PerspectiveSensor& sensor) {
    sensor.orthographic = type == "orthographic" || type == "telecentric";
    if (!takes_pictures(type)) p.fail("", "takes no picture; supported: perspective, thinlens, orthographic");
    if (type == "telecentric" || type == "perspective_rdist")
        p.approximate("", std::string("is not supported: read as ") + (sensor.orthographic ? "orthographic" : "perspective"));
}

void read_lens(Properties& p, const std::string& type, PerspectiveSensor& sensor) {
    if (type != "thinlens") return p.ignore({"focus_distance", "aperture_radius"});
    sensor.aperture_radius = p.number("aperture_radius", 0);
    sensor.focus_distance = p.number("focus_distance", sensor.far_clip);
    if (!(sensor.aperture_radius >= 0)) p.fail("aperture_radius", "aperture_radius must not be negative");
    if (!(sensor.focus_distance > 0)) p.fail("focus_distance", "focus_distance must be positive");
    p.ignore({"blades"});
}

PerspectiveSensor read_at_depth(XmlSource& source, pugi::xml_node node, int depth) {
    Properties p(source, node);
    const std::string type = node.attribute("type").value();
    const std::vector<NestedObject> inner = p.take_objects("sensor");
    if (type == "batch" && !inner.empty() && depth == 0) {
        p.approximate("", "is not supported: the first sensor inside is read");
        return read_at_depth(source, inner[0].node, depth + 1);
    }
    PerspectiveSensor sensor;
    read_type(p, type, sensor);
    const std::vector<NestedObject> films = p.take_objects("film");
    if (films.size() > 1) source.warn(films[1].named_at, p.label() + " has more than one film; the first is used");
    if (!films.empty()) read_film(source, films[0], sensor);
    p.take_objects("sampler");
    if (!sensor.orthographic) sensor.fov_x = read_fov(p, static_cast<double>(sensor.width) / sensor.height);
    sensor.to_world = sensor.orthographic ? p.transform("to_world") : read_frame(p);
    sensor.near_clip = p.number("near_clip", sensor.near_clip);
    sensor.far_clip = p.number("far_clip", sensor.far_clip);
    if (!(sensor.near_clip > 0.0)) p.fail("near_clip", "near_clip must be positive");
    if (!(sensor.near_clip < sensor.far_clip)) p.fail("far_clip", "far_clip must be greater than near_clip");
    read_lens(p, type, sensor);
    sensor.principal_point_offset = {p.number("principal_point_offset_x", 0.0), p.number("principal_point_offset_y", 0.0)};
    p.ignore({"shutter_open", "shutter_close", "sample_count", "srf", "kc"});
    p.finish();
    return sensor;
}

}  // namespace

bool takes_pictures(const std::string& type) {
    const std::vector<std::string> types = {"perspective", "thinlens", "orthographic", "perspective_rdist", "telecentric", "batch"};
    return std::find(types.begin(), types.end(), type) != types.end();
}

PerspectiveSensor read_sensor(XmlSource& source, pugi::xml_node node) { return read_at_depth(source, node, 0); }

PerspectiveSensor default_sensor(const Scene& scene) {
    glm::dvec3 low = scene.positions.at(0), high = low;
    for (const glm::dvec3& position : scene.positions) {
        low = glm::min(low, position);
        high = glm::max(high, position);
    }
    const glm::dvec3 size = high - low, middle = 0.5 * (low + high);
    PerspectiveSensor sensor;  // of 45 degrees
    const double distance = std::max({size.x, size.y, size.z}) / (2.0 * std::tan(0.5 * glm::radians(sensor.fov_x)));
    sensor.near_clip = distance / 100.0;
    sensor.far_clip = 5.0 * glm::length(size) + distance;
    sensor.to_world[3] = glm::dvec4(middle.x, middle.y, low.z - distance, 1.0);
    return sensor;
}

}  // namespace pencil
