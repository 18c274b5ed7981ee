// Defaults are Mitsuba's: 768 x 576, gaussian filter, focal length 50 mm on 36 x 24 mm film when no field of view is given.
#include "scene/mitsuba/read_sensor.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/text.h"

namespace pencil {
namespace {

ReconstructionFilter read_filter(XmlSource& source, const NestedObject& object) {
    using Kind = ReconstructionFilter::Kind;
    Properties p(source, object.node);
    ReconstructionFilter filter;
    if (object.type == "box") {
        filter.kind = Kind::box;
        filter.radius = p.number("radius", 0.5);
    } else if (object.type == "tent") {
        filter.kind = Kind::tent;
        filter.radius = p.number("radius", 1.0);
    } else if (object.type == "gaussian") {
        filter.stddev = p.number("stddev", 0.5);
        if (!(filter.stddev > 0.0)) p.fail("stddev", "stddev must be positive");
        filter.radius = 4.0 * filter.stddev;
    } else if (object.type == "mitchell") {
        filter.kind = Kind::mitchell;
        // The two parameters are named B and C in Mitsuba 0.x, A and B in 3.x; a lone B is told apart by the scene's version.
        const bool old_names = p.has("C") || (!p.has("A") && source.version() < 2);
        filter.b = p.number(old_names ? "B" : "A", 1.0 / 3.0);
        filter.c = p.number(old_names ? "C" : "B", 1.0 / 3.0);
    } else if (object.type == "catmullrom") {
        filter.kind = Kind::catmullrom;
        filter.b = 0.0;
        filter.c = 0.5;
    } else if (object.type == "lanczos") {
        filter.kind = Kind::lanczos;
        filter.radius = static_cast<double>(p.integer("lobes", 3));
    } else {
        p.fail("", "is not supported; supported: box, tent, gaussian, mitchell, catmullrom, lanczos");
    }
    constexpr double widest = 64.0;  // pixels; beyond it the filter is a mistake
    if (!(filter.radius > 0.0 && filter.radius <= widest)) p.fail("radius", "the filter's radius must lie in (0, 64] pixels");
    p.ignore({"radius"});
    p.finish();
    return filter;
}

int read_size(Properties& p, const std::string& name, int absent) {
    const long long size = p.integer(name, absent);
    constexpr long long largest = 1'000'000;  // pixels, as of --resolution
    if (size < 1 || size > largest) p.fail(name, name + " must be from 1 to " + std::to_string(largest) + " pixels");
    return static_cast<int>(size);
}

void read_film(XmlSource& source, const NestedObject& object, PerspectiveSensor& sensor) {
    Properties p(source, object.node);
    if (object.type != "hdrfilm" && object.type != "ldrfilm") p.fail("", "is not supported; supported: hdrfilm, ldrfilm");
    sensor.width = read_size(p, "width", sensor.width);
    sensor.height = read_size(p, "height", sensor.height);
    for (const char* crop : {"crop_width", "crop_height", "crop_offset_x", "crop_offset_y"})
        if (p.has(crop)) source.warn(object.node, p.label() + ": crop windows are not supported, the whole image is rendered");
    p.ignore({"crop_width", "crop_height", "crop_offset_x", "crop_offset_y", "file_format", "pixel_format", "component_format", "banner",
              "gamma", "exposure", "tonemap_method", "key", "burn", "attach_log", "high_quality_edges", "sample_border", "compensate",
              "fast_path"});
    for (const NestedObject& child : p.objects()) {
        if (child.kind != "rfilter") source.fail(child.named_at, "<" + child.kind + "> cannot stand inside " + p.label());
        sensor.filter = read_filter(source, child);
    }
    p.finish();
}

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

}  // namespace

PerspectiveSensor read_sensor(XmlSource& source, pugi::xml_node node) {
    Properties p(source, node);
    if (std::string(node.attribute("type").value()) != "perspective") p.fail("", "is not supported; supported: perspective");
    PerspectiveSensor sensor;
    for (const NestedObject& child : p.objects())
        if (child.kind == "film")
            read_film(source, child, sensor);
        else if (child.kind != "sampler")
            source.fail(child.named_at, "<" + child.kind + "> cannot stand inside " + p.label());
    sensor.fov_x = read_fov(p, static_cast<double>(sensor.width) / sensor.height);
    sensor.to_world = read_frame(p);
    sensor.near_clip = p.number("near_clip", sensor.near_clip);
    sensor.far_clip = p.number("far_clip", sensor.far_clip);
    if (!(sensor.near_clip > 0.0)) p.fail("near_clip", "near_clip must be positive");
    if (!(sensor.near_clip < sensor.far_clip)) p.fail("far_clip", "far_clip must be greater than near_clip");
    sensor.principal_point_offset = {p.number("principal_point_offset_x", 0.0), p.number("principal_point_offset_y", 0.0)};
    p.ignore({"focus_distance", "shutter_open", "shutter_close", "sample_count"});
    p.finish();
    return sensor;
}

}  // namespace pencil
