// Transforms. Each operation multiplies from the left onto those before it (Mitsuba's order); matrices are written row by row.
#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <initializer_list>

#include "scene/mitsuba/xml_values.h"
#include "scene/text.h"

namespace pencil {
namespace {

/// sine of the angle below which `up` counts as parallel to the view
constexpr double parallel = 1e-6;

glm::dvec3 three_numbers(const XmlSource& source, pugi::xml_node node, const char* attribute) {
    const std::vector<std::string_view> parts = tokens(node.attribute(attribute).value());
    if (parts.size() != 3) source.fail(node, std::string("<") + node.name() + "> needs " + attribute + "=\"x, y, z\"");
    glm::dvec3 result(0.0);
    for (int i = 0; i < 3; ++i) {
        const std::optional<double> value = parse_number(parts[static_cast<std::size_t>(i)]);
        if (!value)
            source.fail(node, std::string("<") + node.name() + "> " + attribute + ": " + number_defect(parts[static_cast<std::size_t>(i)]));
        result[i] = *value;
    }
    return result;
}

/// Any axis not parallel to `direction`, for a camera whose up vector is missing or useless.
glm::dvec3 some_up(glm::dvec3 direction) { return std::abs(direction.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1); }

glm::dmat4 look_at(XmlSource& source, pugi::xml_node node) {
    const glm::dvec3 origin = three_numbers(source, node, "origin");
    const glm::dvec3 to_target = three_numbers(source, node, "target") - origin;
    const double distance = glm::length(to_target);
    if (!(distance > 0.0) || !std::isfinite(distance)) source.fail(node, "<lookat>: origin and target are the same point");
    const glm::dvec3 direction = to_target / distance;
    glm::dvec3 up = node.attribute("up") ? three_numbers(source, node, "up") : glm::dvec3(0.0);
    if (up == glm::dvec3(0.0)) {
        up = some_up(direction);
    } else if (glm::length(glm::cross(glm::normalize(up), direction)) < parallel) {
        up = some_up(direction);
        source.warn(node, "<lookat>: up is parallel to the view; another up vector is used");
    }
    const glm::dvec3 left = glm::normalize(glm::cross(up, direction));
    return {glm::dvec4(left, 0.0), glm::dvec4(glm::cross(direction, left), 0.0), glm::dvec4(direction, 0.0), glm::dvec4(origin, 1.0)};
}

glm::dmat4 matrix(const XmlSource& source, pugi::xml_node node) {
    const std::vector<std::string_view> parts = tokens(node.attribute("value").value());
    if (parts.size() != 16 && parts.size() != 9)
        source.fail(node, "<matrix> has " + std::to_string(parts.size()) + " numbers, not 16 (or 9)");
    const int n = parts.size() == 16 ? 4 : 3;
    glm::dmat4 result(1.0);
    for (int i = 0; i < n * n; ++i) {
        const std::string_view part = parts[static_cast<std::size_t>(i)];
        const std::optional<double> value = parse_number(part);
        if (!value) source.fail(node, "<matrix>: " + number_defect(part));
        result[i % n][i / n] = *value;
    }
    const glm::dvec4 last_row(result[0][3], result[1][3], result[2][3], result[3][3]);
    if (last_row != glm::dvec4(0, 0, 0, 1))
        source.fail(node, "<matrix>: the last row must be 0 0 0 1; perspective matrices are not supported");
    return result;
}

/// Exact for quarter turns, so that boxes put together from turned rectangles share their corners.
double cos_degrees(double angle) {
    const double turned = std::abs(std::remainder(angle, 360.0));
    if (turned == 90.0) return 0.0;
    return turned == 180.0 ? -1.0 : std::cos(glm::radians(turned));
}

glm::dmat4 rotation(XmlSource& source, pugi::xml_node node) {
    const glm::dvec3 axis = parse_vector(source, node, 0.0);
    if (!(glm::length(axis) > 0.0)) {
        source.warn(node, "<rotate> has no axis: it turns nothing");
        return glm::dmat4(1.0);
    }
    const glm::dvec3 a = glm::normalize(axis);
    const double angle = attribute_number(source, node, "angle");
    const double c = cos_degrees(angle), s = cos_degrees(angle - 90.0);
    const glm::dvec3 x(a.x * a.x, a.x * a.y, a.x * a.z), y(a.x * a.y, a.y * a.y, a.y * a.z), z(a.x * a.z, a.y * a.z, a.z * a.z);
    return {glm::dvec4(x * (1.0 - c) + glm::dvec3(c, s * a.z, -s * a.y), 0.0),
            glm::dvec4(y * (1.0 - c) + glm::dvec3(-s * a.z, c, s * a.x), 0.0),
            glm::dvec4(z * (1.0 - c) + glm::dvec3(s * a.y, -s * a.x, c), 0.0), glm::dvec4(0.0, 0.0, 0.0, 1.0)};
}

void check_attributes(XmlSource& source, pugi::xml_node node, std::initializer_list<std::string> known) {
    for (const pugi::xml_attribute attribute : node.attributes()) {
        if (std::find(known.begin(), known.end(), attribute.name()) != known.end()) continue;
        const std::string close = closest_name(attribute.name(), known);
        source.warn(node, std::string("<") + node.name() + "> has no attribute " + in_quotes(attribute.name()) + ": ignored" +
                              (close.empty() ? "" : "; did you mean " + in_quotes(close) + "?"));
    }
}

glm::dmat4 operation(XmlSource& source, pugi::xml_node node) {
    const std::string tag = node.name();
    if (tag == "translate" || tag == "scale") {
        check_attributes(source, node, {"x", "y", "z", "value"});
        if (tag == "scale") return glm::scale(glm::dmat4(1.0), parse_vector(source, node, 1.0));
        return glm::translate(glm::dmat4(1.0), parse_vector(source, node, 0.0));
    }
    if (tag == "rotate") {
        check_attributes(source, node, {"x", "y", "z", "value", "angle"});
        return rotation(source, node);
    }
    if (tag == "lookat" || tag == "look_at" || tag == "lookAt") {
        check_attributes(source, node, {"origin", "target", "up"});
        return look_at(source, node);
    }
    if (tag != "matrix") source.fail(node, "<" + tag + "> is not a transform; use translate, rotate, scale, lookat or matrix");
    check_attributes(source, node, {"value"});
    return matrix(source, node);
}

}  // namespace

double attribute_number(const XmlSource& source, pugi::xml_node node, const char* attribute) {
    if (!node.attribute(attribute)) source.fail(node, std::string("<") + node.name() + "> needs the attribute \"" + attribute + "\"");
    const std::string text = node.attribute(attribute).value();
    const std::optional<double> value = parse_number(text);
    if (!value) source.fail(node, std::string("<") + node.name() + "> " + attribute + ": " + number_defect(text));
    return *value;
}

glm::dvec3 parse_vector(const XmlSource& source, pugi::xml_node node, double absent) {
    const char* const axes[] = {"x", "y", "z"};
    if (node.attribute("value")) {
        for (const char* axis : axes)
            if (node.attribute(axis)) source.fail(node, std::string("<") + node.name() + "> has both value and " + axis);
        const std::size_t count = tokens(node.attribute("value").value()).size();
        return count == 1 ? glm::dvec3(attribute_number(source, node, "value")) : three_numbers(source, node, "value");
    }
    glm::dvec3 result(absent);
    for (int i = 0; i < 3; ++i)
        if (node.attribute(axes[i])) result[i] = attribute_number(source, node, axes[i]);
    return result;
}

glm::dmat4 parse_transform(XmlSource& source, pugi::xml_node node) {
    glm::dmat4 result(1.0);
    for (const pugi::xml_node child : node.children()) {
        result = operation(source, child) * result;
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row)
                if (!std::isfinite(result[column][row])) source.fail(child, "the transform overflows");
        }
    }
    return result;
}

}  // namespace pencil
