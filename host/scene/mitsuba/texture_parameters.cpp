#include "scene/mitsuba/texture_parameters.h"

#include "scene/text.h"

namespace pencil {
namespace {

Texture::Wrap read_wrap(Properties& p, const std::string& name, Texture::Wrap absent) {
    if (!p.has(name)) return absent;
    const std::string mode = p.text(name, "repeat");
    if (mode == "repeat") return Texture::Wrap::repeat;
    if (mode == "mirror") return Texture::Wrap::mirror;
    if (mode != "clamp") p.approximate(name, name + " " + in_quotes(mode) + " is not supported: read as \"clamp\"");
    return Texture::Wrap::clamp;
}

TextureUse::Channel named_channel(Properties& p, TextureUse::Channel absent) {
    const std::string name = p.text("channel", "");
    if (name.empty() || name == "all") return absent;
    if (name == "r") return TextureUse::Channel::red;
    if (name == "g") return TextureUse::Channel::green;
    if (name == "b") return TextureUse::Channel::blue;
    if (name == "a") return TextureUse::Channel::opacity;
    p.approximate("channel", "channel " + in_quotes(name) + " is not supported: all are read");
    return absent;
}

}  // namespace

glm::dmat3 read_to_uv(Properties& p) {
    if (p.has("to_uv")) {
        const glm::dmat4 m = p.transform("to_uv");
        // A <translate> stands in the fourth column, that of a 3 x 3 <matrix> in the third.
        return {m[0].x, m[0].y, 0, m[1].x, m[1].y, 0, m[2].x + m[3].x, m[2].y + m[3].y, 1};
    }
    const double u = p.number("uscale", 1), v = p.number("vscale", 1);
    return {u, 0, 0, 0, v, 0, p.number("uoffset", 0), p.number("voffset", 0), 1};
}

TextureSampling read_sampling(Properties& p) {
    TextureSampling sampling;
    sampling.to_uv = read_to_uv(p);
    const std::string filter = p.text("filter_type", "bilinear");
    sampling.nearest = filter == "nearest";
    const Texture::Wrap both = read_wrap(p, "wrap_mode", Texture::Wrap::repeat);
    sampling.wrap_u = read_wrap(p, "wrap_mode_u", both);
    sampling.wrap_v = read_wrap(p, "wrap_mode_v", both);
    p.ignore({"max_anisotropy", "cache", "accel", "format", "mip"});
    return sampling;
}

TextureUse read_use(Properties& p, TextureUse::Channel channel) {
    TextureUse use;
    use.channel = named_channel(p, channel);
    const double gamma = p.number("gamma", -1);  // -1: sRGB
    use.gamma = gamma > 0 ? gamma : 0;
    if (p.boolean("raw", false) || !p.boolean("srgb", true)) use.gamma = 1;
    return use;
}

}  // namespace pencil
