// From the checked XML tree to a Scene, element by element. Every material of the file is read, so that a mistake shows even where nothing
// uses it yet.
#include "scene/mitsuba/read_mitsuba.h"

#include "scene/mitsuba/read_bsdf.h"
#include "scene/mitsuba/read_emitter.h"
#include "scene/mitsuba/read_integrator.h"
#include "scene/mitsuba/read_sensor.h"
#include "scene/mitsuba/read_shape.h"
#include "scene/scene_file.h"
#include "util/error.h"

namespace pencil {
namespace {

class SceneReader {
public:
    explicit SceneReader(XmlSource& source) : source_(source), shapes_(source, scene_) { scene_.file = source.file().string(); }

    Scene read() {
        for (const pugi::xml_node node : source_.root().children()) top_level(node);
        if (!has_sensor_) throw SceneError(shown(source_.file()), "the scene has no sensor; add <sensor type=\"perspective\">");
        scene_.warnings = source_.warnings();
        return std::move(scene_);
    }

private:
    void top_level(pugi::xml_node node) {
        const std::string tag = node.name();
        if (tag == "default" || tag == "alias") return;
        if (tag == "integrator") return integrator(node);
        if (tag == "sensor") return sensor(node);
        if (tag == "bsdf") return (void)read_bsdf(source_, node);
        if (tag == "shape") return shapes_.read(node);
        if (tag == "emitter") return scene_.point_lights.push_back(read_point_light(source_, node));
        const bool plugin = tag == "texture" || tag == "medium" || tag == "volume" || tag == "phase";
        source_.fail(node, "<" + tag + "> " + (plugin ? "is not supported" : "cannot stand directly inside <scene>"));
    }

    void integrator(pugi::xml_node node) {
        if (has_integrator_) source_.fail(node, "the scene has more than one integrator");
        has_integrator_ = true;
        scene_.max_depth = read_max_depth(source_, node);
    }

    void sensor(pugi::xml_node node) {
        const PerspectiveSensor sensor = read_sensor(source_, node);
        if (has_sensor_) return source_.warn(node, "the scene has more than one sensor; the first is used");
        has_sensor_ = true;
        scene_.sensor = sensor;
    }

    XmlSource& source_;
    Scene scene_;
    ShapeReader shapes_;
    bool has_integrator_ = false, has_sensor_ = false;
};

}  // namespace

Scene read_mitsuba(const std::filesystem::path& file, const LoadOptions& options) {
    XmlSource source(file, options.defines);
    return SceneReader(source).read();
}

}  // namespace pencil
