// Mitsuba's textures, and the parameters of materials and lights that may be textures.
#pragma once

#include <map>
#include <string>
#include <tuple>

#include "scene/mitsuba/properties.h"
#include "scene/scene.h"
#include "scene/textures/add_texture.h"

namespace pencil {

/// A colour, or the product of one and a texture. `missing`: its picture is not there.
struct ColourSlot {
    glm::vec3 value{1.0F};
    int texture = no_texture;
    bool missing = false;
};

/// A number, or the product of one and a texture's red channel.
struct NumberSlot {
    float value = 1.0F;
    int texture = no_texture;
    bool missing = false;
};

class TextureReader {
public:
    TextureReader(XmlSource& source, Scene& scene) : source_(source), scene_(scene) {}

    /// `absent` stands in for pictures that are not there, too.
    ColourSlot colour(Properties& p, const std::string& name, glm::vec3 absent, ColourUse use);
    NumberSlot number(Properties& p, const std::string& name, double absent);
    /// A nested texture. With channel `all`, colours for `use`; with another, that channel in red, green and blue.
    ColourSlot read(const NestedObject& object, ColourUse use, TextureUse::Channel channel);

    XmlSource& source() const { return source_; }
    Scene& scene() const { return scene_; }

private:
    ColourSlot read_new(const NestedObject& object, ColourUse use, TextureUse::Channel channel, int depth);
    ColourSlot read_nested(const NestedObject& object, ColourUse use, TextureUse::Channel channel, int depth);
    ColourSlot bitmap(Properties& p, ColourUse colours, TextureUse::Channel channel);
    ColourSlot readable_bitmap(Properties& p, ColourUse colours, TextureUse::Channel channel);
    ColourSlot missing(Properties& p, const std::string& message);
    ColourSlot checkerboard(Properties& p, ColourUse use, TextureUse::Channel channel);
    ColourSlot scaled(Properties& p, ColourUse use, TextureUse::Channel channel, int depth);
    ColourSlot vertex_colours(Properties& p);
    ColourSlot mean(Properties& p, ColourUse use);
    int append(Texture texture);

    XmlSource& source_;
    Scene& scene_;
    std::map<std::tuple<std::size_t, ColourUse, TextureUse::Channel>, ColourSlot> done_;  // by node and use
};

}  // namespace pencil
