// Most have a signature. Text without one is told by its first statement: comments are passed over, then a keyword and its operand count.
#include "scene/formats/other_formats.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "scene/text.h"
#include "scene/xml_head.h"

namespace pencil {
namespace {

bool begins_with(std::string_view text, std::string_view start) { return text.substr(0, start.size()) == start; }

bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// `words` are separated by blanks.
bool is_one_of(std::string_view word, std::string_view words) {
    const std::vector<std::string_view> list = tokens(words);
    return std::find(list.begin(), list.end(), word) != list.end();
}

float float_at(std::string_view bytes, std::size_t at) {
    float value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

/// 80 bytes of any kind, the number of triangles, and 50 bytes for each: normal, three corners, two bytes of any kind.
bool is_binary_stl(std::string_view head) {
    constexpr std::size_t begin = 84, step = 50;
    const bool utf16 = begins_with(head, "\xff\xfe") || begins_with(head, "\xfe\xff");  // text whose zeros look like small numbers
    if (utf16 || head.size() < begin + step) return false;
    std::uint32_t count = 0;
    std::memcpy(&count, head.data() + begin - sizeof count, sizeof count);
    const std::size_t seen = std::min<std::size_t>(count, (head.size() - begin) / step);
    if (seen == 0) return false;
    for (std::size_t i = 0; i < seen; ++i) {
        float square = 0;
        for (std::size_t k = 0; k < 12; ++k) {
            const float value = float_at(head, begin + step * i + sizeof(float) * k);
            if (!std::isfinite(value)) return false;
            if (k < 3) square += value * value;
        }
        constexpr float tolerance = 0.01F;  // normals are written with few digits, or as zero
        if (square != 0.0F && std::abs(square - 1.0F) > tolerance) return false;
    }
    return true;
}

}  // namespace

bool is_stl(std::string_view head) { return (begins_with(head, "solid") && contains(head, "facet")) || is_binary_stl(head); }

bool is_usd(std::string_view head) {
    return begins_with(head, "#usda") || begins_with(head, "PXR-USDC") || (begins_with(head, "PK\x03\x04") && contains(head, ".usd"));
}

bool is_fbx(std::string_view head) { return begins_with(head, "Kaydara FBX Binary") || begins_with(head, "; FBX"); }

bool is_collada(std::string_view head) { return xml_root(head) == "COLLADA"; }

bool is_alembic(std::string_view head) { return begins_with(head, "Ogawa") || begins_with(head, "\x89HDF\r\n\x1a\n"); }

bool is_blender(std::string_view head) { return begins_with(head, "BLENDER"); }

bool is_pbrt(std::string_view head) {
    constexpr std::string_view alone = "WorldBegin AttributeBegin TransformBegin Identity";
    constexpr std::string_view with_operand =
        "Accelerator Camera ColorSpace ConcatTransform CoordSysTransform Film Filter Import Include Integrator LookAt MakeNamedMaterial "
        "MakeNamedMedium Option PixelFilter Renderer Rotate Sampler Scale Shape SurfaceIntegrator Texture Transform Translate "
        "VolumeIntegrator";
    const std::string_view line = first_statement(head), word = line.substr(0, line.find_first_of(" \t\"["));
    const std::string_view operand = trimmed(line.substr(word.size()));
    if (operand.empty() || operand[0] == '#') return is_one_of(word, alone) || (operand.empty() && is_one_of(word, with_operand));
    return is_one_of(word, with_operand) && contains("\"[+-.0123456789", operand.substr(0, 1));
}

bool is_png(std::string_view head) { return begins_with(head, "\x89PNG\r\n\x1a\n"); }

bool is_exr(std::string_view head) { return begins_with(head, "\x76\x2f\x31\x01"); }

bool is_hdr(std::string_view head) { return begins_with(head, "#?RADIANCE") || begins_with(head, "#?RGBE"); }

}  // namespace pencil
