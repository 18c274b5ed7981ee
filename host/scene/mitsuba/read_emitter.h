// Mitsuba's emitters: those that stand in the scene, and the area emitters inside shapes.
#pragma once

#include <map>

#include "scene/mitsuba/properties.h"
#include "scene/mitsuba/read_texture.h"
#include "scene/scene.h"

namespace pencil {

class EmitterReader {
public:
    EmitterReader(XmlSource& source, Scene& scene, TextureReader& textures) : source_(source), scene_(scene), textures_(textures) {}

    /// Of an emitter that stands directly inside <scene>: appends it.
    void read(pugi::xml_node node);
    /// Of an emitter inside a shape: radiance [W m^-2 sr^-1].
    void read_area(const NestedObject& object, Shape& shape);

private:
    void point(Properties& p);
    void spot(Properties& p);
    void directional(Properties& p);
    void constant(Properties& p);
    void envmap(Properties& p);
    void sun_and_sky(Properties& p, const std::string& type);
    void photometric(Properties& p);
    void set_environment(Properties& p, Environment environment);
    void finish(Properties& p);

    XmlSource& source_;
    Scene& scene_;
    TextureReader& textures_;
};

}  // namespace pencil
