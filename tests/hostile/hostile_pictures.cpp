// Rows 30 to 32: textures whose headers lie, that are cut, or of kinds that are not read.
#include <cstdint>
#include <limits>

#include "hostile/hostile_case.h"

namespace pencil_test {
namespace {

/// A scene whose one texture is this file.
HostileCase picture(const std::string& name, int code, const std::string& says, const std::string& file,
                    const std::function<std::string()>& bytes) {
    return {name, code, says,
            [=](const Folder& folder) {
                if (const std::string content = bytes(); !content.empty()) folder.write(file, content);
                const std::string body =
                    "<shape type=\"rectangle\"><bsdf type=\"diffuse\"><texture type=\"bitmap\" name=\"reflectance\">"
                    "<string name=\"filename\" value=\"" +
                    file + "\"/></texture></bsdf></shape>";
                return Arguments{"info", folder.write("scene.xml", scene_around(body))};
            }};
}

std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255);
    return bytes;
}

std::uint32_t crc(const std::string& bytes) {
    std::uint32_t rest = 0xffffffffU;
    for (const char c : bytes) {
        rest ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) rest = (rest >> 1) ^ (0xedb88320U & (0U - (rest & 1U)));
    }
    return ~rest;
}

std::string png_chunk(const std::string& type, const std::string& data) {
    return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(crc(type + data));
}

/// A right header of so many pixels, and no data.
std::string png(std::uint32_t width, std::uint32_t height) {
    const std::string head = big_endian(width) + big_endian(height) + std::string("\x08\x02\0\0\0", 5);
    return std::string("\x89PNG\r\n\x1a\n", 8) + png_chunk("IHDR", head) + png_chunk("IDAT", std::string("\x78\x9c\x03\0\0\0\0\x01", 8)) +
           png_chunk("IEND", "");
}

std::string floats_of(const std::vector<float>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

/// The header of an OpenEXR file with this data window.
std::string exr(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1) {
    const auto number = [](std::int32_t value) {
        std::string bytes;
        for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(static_cast<std::uint32_t>(value) >> shift & 255);
        return bytes;
    };
    const auto attribute = [&](const std::string& name, const std::string& type, const std::string& value) {
        return name + '\0' + type + '\0' + number(static_cast<std::int32_t>(value.size())) + value;
    };
    const std::string window = number(x0) + number(y0) + number(x1) + number(y1);
    std::string channels;
    for (const char c : {'B', 'G', 'R'}) channels += c + std::string(1, '\0') + number(1) + number(0) + number(1) + number(1);
    channels += '\0';
    const float one = 1, none[2] = {0, 0};
    return std::string("\x76\x2f\x31\x01\x02\0\0\0", 8) + attribute("channels", "chlist", channels) +
           attribute("compression", "compression", {'\0'}) + attribute("dataWindow", "box2i", window) +
           attribute("displayWindow", "box2i", window) + attribute("lineOrder", "lineOrder", {'\0'}) +
           attribute("pixelAspectRatio", "float", floats_of({one})) +
           attribute("screenWindowCenter", "v2f", floats_of({none[0], none[1]})) +
           attribute("screenWindowWidth", "float", floats_of({one})) + '\0';
}

}  // namespace

std::vector<HostileCase> hostile_pictures() {
    const std::int32_t most = std::numeric_limits<std::int32_t>::max();
    const auto text = [](const std::string& bytes) { return [=] { return bytes; }; };
    const std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";
    return {
        picture("30-png-100000^2", 3, "too large", "a.png", [] { return png(100000, 100000); }),
        picture("30-png-8000^2", 3, "damaged", "a.png", [] { return png(8000, 8000); }),
        picture("30-png-2^31", 3, "", "a.png", [] { return png(0x7fffffffU, 0x7fffffffU); }),
        picture("30-png-0", 3, "", "a.png", [] { return png(0, 16); }),
        picture("30-hdr-2e9^2", 3, "", "a.hdr", text(hdr + "-Y 2000000000 +X 2000000000\n")),
        picture("30-hdr-0", 3, "", "a.hdr", text(hdr + "-Y 0 +X 0\n")),
        picture("30-exr-2^31", 3, "", "a.exr", [=] { return exr(0, 0, most, most); }),
        picture("30-exr-30000^2", 3, "", "a.exr", [=] { return exr(0, 0, 29999, 29999); }),
        picture("30-exr-inside-out", 3, "", "a.exr", [=] { return exr(5, 5, -5, -5); }),
        picture("30-ppm--5", 3, "", "a.ppm", text("P6\n-5 5\n255\n")),
        picture("30-ppm-1e5^2", 3, "", "a.ppm", text("P6\n100000 100000\n255\n")),
        picture("30-pfm-1e5^2", 3, "", "a.pfm", text("PF\n100000 100000\n-1.0\n")),
        picture("31-png-cut", 3, "", "a.png", [] { return png(64, 64).substr(0, 40); }),
        picture("31-png-no-data", 3, "", "a.png", [] { return png(64, 64); }),
        picture("31-png-wrong-sum", 3, "", "a.png",
                [] {
                    std::string bytes = png(4, 4);
                    bytes[29] ^= 1;
                    return bytes;
                }),
        picture("31-pfm-not-finite", 0, "", "a.pfm",
                [] {
                    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
                    return "PF\n2 2\n-1.0\n" + floats_of({inf, -inf, nan, -1, 0, 0, 1e38F, 1, 1, 1, 1, 1});
                }),
        picture("32-png-named-exr", 3, "", "a.exr", [] { return png(64, 64); }),
        picture("32-dpx", 3, "known format", "a.png", text("SDPX" + std::string(2048, '\0'))),
        picture("32-sgi", 3, "known format", "a.png",
                text(std::string("\x01\xda\0\x01\0\x03\0\x10\0\x10\0\x03", 12) + std::string(600, '\0'))),
        picture("32-text", 3, "known format", "a.png", text("hello")),
        picture("32-missing", 0, "is not there", "b.png", text("")),
    };
}

}  // namespace pencil_test
