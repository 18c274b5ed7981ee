#include "scene/mitsuba/read_texture.h"

#include <algorithm>
#include <glm/common.hpp>

#include "scene/mitsuba/texture_parameters.h"
#include "scene/text.h"

namespace pencil {
namespace {

constexpr int deepest_texture = 8;  // of nested textures; a longer chain is a circle of references

float luminance(glm::vec3 c) { return 0.212671F * c.x + 0.715160F * c.y + 0.072169F * c.z; }

bool same(const Texture& a, const Texture& b) {
    return a.kind == b.kind && a.to_uv == b.to_uv && a.colours[0] == b.colours[0] && a.colours[1] == b.colours[1] && a.name == b.name;
}

}  // namespace

ColourSlot TextureReader::colour(Properties& p, const std::string& name, glm::vec3 absent, ColourUse use) {
    ColourSlot slot{absent, no_texture, false};
    if (const auto texture = p.take_texture(name)) {
        slot = read(*texture, use, TextureUse::Channel::all);
        if (slot.missing) slot.value = absent;
        if (use == ColourUse::reflectance && slot.value != glm::min(slot.value, glm::vec3(1.0F))) {
            p.approximate(name, in_quotes(name) + " is scaled beyond 1: cut to 1");
            slot.value = glm::min(slot.value, glm::vec3(1.0F));
        }
        return slot;
    }
    slot.value = p.colour(name, absent, use);
    return slot;
}

NumberSlot TextureReader::number(Properties& p, const std::string& name, double absent) {
    if (const auto texture = p.take_texture(name)) {
        const ColourSlot slot = read(*texture, ColourUse::coefficient, TextureUse::Channel::luminance);
        return {slot.missing ? static_cast<float>(absent) : luminance(slot.value), slot.texture, slot.missing};
    }
    // Some exporters write numbers as grey colours.
    const glm::vec3 value = p.colour(name, glm::vec3(static_cast<float>(absent)), ColourUse::coefficient);
    return {value.x == value.y && value.y == value.z ? value.x : luminance(value), no_texture, false};
}

ColourSlot TextureReader::read(const NestedObject& object, ColourUse use, TextureUse::Channel channel) {
    return read_nested(object, use, channel, 0);
}

/// A texture with a defect is white; the defect is told at the end.
ColourSlot TextureReader::read_nested(const NestedObject& object, ColourUse use, TextureUse::Channel channel, int depth) {
    const std::size_t node = object.node.hash_value();
    const auto place = done_.find({node, use, channel});
    if (place != done_.end()) return place->second;
    ColourSlot slot;
    source_.problems().attempt([&] {
        if (depth > deepest_texture) source_.fail(object.named_at, "this texture refers to itself, or holds too many others");
        slot = read_new(object, use, channel, depth);
    });
    return done_[{node, use, channel}] = slot;
}

ColourSlot TextureReader::read_new(const NestedObject& object, ColourUse use, TextureUse::Channel channel, int depth) {
    Properties p(source_, object.node);
    const std::string& type = object.type;
    ColourSlot slot;
    if (type == "bitmap" || type == "ldrtexture" || type == "exrtexture")
        slot = source_.is_of_another_format(object.node) ? readable_bitmap(p, use, channel) : bitmap(p, use, channel);
    else if (type == "checkerboard")
        slot = checkerboard(p, use, channel);
    else if (type == "scale")
        slot = scaled(p, use, channel, depth);
    else if (type == "mesh_attribute" || type == "vertexcolors")
        slot = vertex_colours(p);
    else
        slot = mean(p, use);
    p.finish();
    return slot;
}

/// Scenes are published without some of their pictures; how bright a lamp is cannot be guessed.
ColourSlot TextureReader::bitmap(Properties& p, ColourUse colours, TextureUse::Channel channel) {
    const TextureSampling sampling = read_sampling(p);
    const TextureUse use = read_use(p, channel);
    if (!p.has("filename")) p.fail("", "needs a filename");
    const std::string name = p.text("filename", "");
    std::optional<std::filesystem::path> file = source_.find_file_if_there(name, p.node());
    if (!file && colours == ColourUse::emission) file = source_.find_file(name, p.node());
    if (file) return {glm::vec3(1.0F), add_texture_file(scene_, *file, use, source_.where(p.node()), sampling), false};
    return missing(p, "picture " + in_quotes(name) + " is not there: the default of what it is for stands in for it; " +
                          "put it into the scene's folder, or give --allow FOLDER");
}

/// Of libraries of materials, as files of the web have them: what cannot be read is as good as not there.
ColourSlot TextureReader::readable_bitmap(Properties& p, ColourUse colours, TextureUse::Channel channel) {
    try {
        return bitmap(p, colours, channel);
    } catch (const SceneError& error) {
        return missing(p, without_place(error, source_.where(p.node())) + "; it is left out");
    }
}

ColourSlot TextureReader::missing(Properties& p, const std::string& message) {
    p.approximate("filename", message);
    return {glm::vec3(1.0F), no_texture, true};
}

ColourSlot TextureReader::checkerboard(Properties& p, ColourUse use, TextureUse::Channel channel) {
    Texture texture;
    texture.kind = Texture::Kind::checkerboard;
    texture.name = "checkerboard";
    texture.to_uv = read_to_uv(p);
    const char* const names[] = {"color0", "color1"};
    for (int i = 0; i < 2; ++i) {
        const ColourSlot slot = colour(p, names[i], texture.colours[i], use);
        if (slot.texture != no_texture) p.approximate(names[i], "a texture inside a checkerboard is not supported: its square is plain");
        texture.colours[i] = channel == TextureUse::Channel::all ? slot.value : glm::vec3(luminance(slot.value));
    }
    p.ignore({"line_width"});
    return {glm::vec3(1.0F), append(std::move(texture)), false};
}

/// 0.x: a nested texture times "scale".
ColourSlot TextureReader::scaled(Properties& p, ColourUse use, TextureUse::Channel channel, int depth) {
    const glm::vec3 factor = p.colour("scale", glm::vec3(1.0F), ColourUse::coefficient);
    const std::vector<NestedObject> inner = p.take_objects("texture");
    if (inner.size() > 1) p.fail("", "needs one nested texture");
    if (inner.empty()) return {factor * p.colour("value", glm::vec3(1.0F), use), no_texture, false};
    ColourSlot slot = read_nested(inner[0], use, channel, depth + 1);
    slot.value *= factor;
    return slot;
}

ColourSlot TextureReader::vertex_colours(Properties& p) {
    const std::string name = p.text("name", "vertex_color");
    if (name != "vertex_color" && name != "vertex_colors")
        p.approximate("name", "attribute " + in_quotes(name) + " is not supported: the vertices' colours are read instead");
    Texture texture;
    texture.kind = Texture::Kind::vertex_colours;
    texture.name = "vertex colours";
    return {glm::vec3(static_cast<float>(p.number("scale", 1))), append(std::move(texture)), false};
}

/// Stands in for what is not supported: one of its colours, or grey.
ColourSlot TextureReader::mean(Properties& p, ColourUse use) {
    glm::vec3 colour(0.5F);
    for (const char* name : {"color0", "interior_color", "color", "value", "reflectance"}) {
        if (!p.has(name)) continue;
        colour = p.colour(name, colour, use);
        break;
    }
    const std::string type = p.node().attribute("type").value();
    if (type != "uniform" && type != "constant" && type != "srgb" && type != "rgb")
        p.approximate("", "is not supported: read as one plain colour");
    p.ignore({"color0", "color1", "line_width", "edge_color", "edge_width", "interior_color", "uscale", "vscale", "uoffset", "voffset",
              "to_uv"});
    return {colour, no_texture, false};
}

int TextureReader::append(Texture texture) {
    const auto place =
        std::find_if(scene_.textures.begin(), scene_.textures.end(), [&](const Texture& other) { return same(other, texture); });
    if (place != scene_.textures.end()) return static_cast<int>(place - scene_.textures.begin());
    scene_.textures.push_back(std::move(texture));
    return static_cast<int>(scene_.textures.size()) - 1;
}

}  // namespace pencil
