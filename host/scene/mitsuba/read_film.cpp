// Defaults are Mitsuba's: 768 x 576, gaussian filter.
#include "scene/mitsuba/read_film.h"

#include <algorithm>

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
        const bool old_names = p.has("C") || (!p.has("A") && source.version(object.node) < 2);
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
        if (!source.is_undefined(object.node)) p.approximate("", "is not supported: read as gaussian");
        filter.radius = 4.0 * filter.stddev;
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

/// A window in pixels of the whole film; the whole film is no window.
void read_crop(Properties& p, PerspectiveSensor& sensor) {
    if (!p.has("crop_width") && !p.has("crop_height") && !p.has("crop_offset_x") && !p.has("crop_offset_y")) return;
    const auto offset = [&](const char* name, int size) {
        const long long value = p.integer(name, 0);
        if (value < 0 || value >= size) p.fail(name, std::string(name) + " lies outside the film");
        return static_cast<int>(value);
    };
    const int x = offset("crop_offset_x", sensor.width), y = offset("crop_offset_y", sensor.height);
    const int width = read_size(p, "crop_width", sensor.width - x), height = read_size(p, "crop_height", sensor.height - y);
    if (width > sensor.width - x) p.fail("crop_width", "the crop window leaves the film");
    if (height > sensor.height - y) p.fail("crop_height", "the crop window leaves the film");
    if (width == sensor.width && height == sensor.height) return;
    sensor.crop_x = x;
    sensor.crop_y = y;
    sensor.crop_width = width;
    sensor.crop_height = height;
}

}  // namespace

void read_film(XmlSource& source, const NestedObject& object, PerspectiveSensor& sensor) {
    Properties p(source, object.node);
    const std::vector<std::string> films = {"hdrfilm", "ldrfilm", "tiledhdrfilm", "specfilm", "mfilm", "exrfilm", "pngfilm", "multifilm"};
    if (std::find(films.begin(), films.end(), object.type) == films.end() && !source.is_undefined(object.node))
        p.approximate("", "is not known: read as hdrfilm");
    sensor.width = read_size(p, "width", sensor.width);
    sensor.height = read_size(p, "height", sensor.height);
    read_crop(p, sensor);
    const std::vector<NestedObject> filters = p.take_objects("rfilter");
    if (!filters.empty()) sensor.filter = read_filter(source, filters[0]);
    p.ignore({"file_format", "pixel_format", "component_format", "banner", "gamma", "exposure", "tonemap_method", "key", "burn",
              "attach_log", "high_quality_edges", "sample_border", "compensate", "fast_path", "variable", "digits", "channel_names",
              "has_variance", "size"});
    if (object.type == "specfilm" || object.type == "mfilm") p.take_objects("texture");
    p.finish();
}

}  // namespace pencil
