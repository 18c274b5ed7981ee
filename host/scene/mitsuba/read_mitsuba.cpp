// From the checked XML trees to a Scene, element by element. A defect ends one element, not the reading: all defects are told at once. Every
// material of the file is read, so that a mistake shows even where nothing uses it yet.
#include "scene/mitsuba/read_mitsuba.h"

#include "scene/mitsuba/read_bsdf.h"
#include "scene/mitsuba/read_emitter.h"
#include "scene/mitsuba/read_integrator.h"
#include "scene/mitsuba/read_sensor.h"
#include "scene/mitsuba/read_shape.h"
#include "scene/mitsuba/read_texture.h"
#include "scene/scene_file.h"
#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace {

class SceneReader {
public:
    SceneReader(XmlSource& source, bool camera)
        : source_(source),
          camera_(camera),
          textures_(source, scene_),
          bsdfs_(source, scene_, textures_),
          emitters_(source, scene_, textures_),
          shapes_(source, scene_, bsdfs_, emitters_) {
        scene_.file = source.file().string();
    }

    Scene read() {
        Problems& problems = source_.problems();
        const std::vector<pugi::xml_node> nodes = source_.children(source_.root());
        shapes_.expect(nodes);
        for (const pugi::xml_node node : nodes) problems.attempt([&] { top_level(node); });
        check_materials(nodes);
        judge_sensors();
        problems.throw_errors();
        scene_.warnings = problems.warnings();
        return std::move(scene_);
    }

private:
    void top_level(pugi::xml_node node) {
        const std::string tag = node.name();
        if (tag == "default" || tag == "alias" || tag == "path" || tag == "bsdf" || tag == "texture" || tag == "subsurface") return;
        if (tag == "integrator") return integrator(node);
        if (tag == "sensor" || tag == "camera") return sensor(node);
        if (tag == "shape") return shapes_.read(node);
        if (tag == "emitter" || tag == "luminaire") return emitters_.read(node);
        if (tag == "medium" || tag == "volume" || tag == "phase") return;  // told where a shape or sensor uses it
        if (tag == "ref") return top_level(source_.find(node.attribute("id").value(), node));
        const bool is_shared = tag == "film" || tag == "sampler" || tag == "rfilter";
        if (is_shared && node.attribute("id")) return;  // for sensors that refer to it
        const bool has_no_effect = is_shared || tag == "boolean" || tag == "integer" || tag == "float" || tag == "string";
        if (has_no_effect) return source_.warn(node, "<" + tag + "> directly inside <scene> has no effect: ignored");
        source_.fail(node, "<" + tag + "> cannot stand directly inside <scene>");
    }

    void check_materials(const std::vector<pugi::xml_node>& nodes) {
        std::vector<pugi::xml_node> bsdfs;
        for (const pugi::xml_node node : nodes)
            if (std::string(node.name()) == "bsdf") bsdfs.push_back(node);
        bsdfs_.check(bsdfs);
    }

    void integrator(pugi::xml_node node) {
        if (has_integrator_) return source_.warn(node, "the scene has more than one integrator; the first is used");
        has_integrator_ = true;
        scene_.max_depth = read_max_depth(source_, node);
    }

    /// The first that takes pictures; others are read for their defects.
    void sensor(pugi::xml_node node) {
        const std::string type = node.attribute("type").value();
        if (!takes_pictures(type)) return without_picture_.push_back(node);
        if (has_sensor_) source_.warn(node, "the scene has more than one sensor; the first is used");
        const PerspectiveSensor sensor = read_sensor(source_, node);
        if (!has_sensor_) scene_.sensor = sensor;
        has_sensor_ = true;
    }

    void judge_sensors() {
        if (!camera_) return;
        for (const pugi::xml_node node : without_picture_)
            if (has_sensor_)
                source_.approximate(node, "sensor type " + in_quotes(node.attribute("type").value()) + " takes no picture: left out");
            else
                source_.problems().attempt([&] { read_sensor(source_, node); });  // says what is supported
        if (has_sensor_ || source_.problems().has_errors()) return;
        if (scene_.triangles.empty()) throw SceneError(shown(source_.file()), "the scene has no sensor; add <sensor type=\"perspective\">");
        source_.approximate(source_.root(), "the scene has no sensor: one is added that sees all shapes from -z, as in Mitsuba");
        scene_.sensor = default_sensor(scene_);
    }

    XmlSource& source_;
    bool camera_;
    Scene scene_;
    TextureReader textures_;
    BsdfReader bsdfs_;
    EmitterReader emitters_;
    ShapeReader shapes_;
    std::vector<pugi::xml_node> without_picture_;  // sensors
    bool has_integrator_ = false, has_sensor_ = false;
};

}  // namespace

Scene read_mitsuba(const std::filesystem::path& file, const LoadOptions& options) {
    XmlSource source(file, options);
    return SceneReader(source, options.camera).read();
}

}  // namespace pencil
