// Little-endian. At the end of the file the meshes' places (64 bits each, 32 in version 3) and their number (32 bits); at each place a magic
// number, the version, and the packed mesh: flags, name (version 4), counts, arrays.
#include "scene/meshes/read_serialized.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "scene/meshes/inflate.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr std::uint16_t magic = 0x041C;
enum Flag : std::uint32_t { has_normals = 0x0001, has_uvs = 0x0002, has_colours = 0x0008, is_flat = 0x0010, is_double = 0x2000 };

template <class T>
T little(std::string_view bytes, std::size_t at) {
    T value = 0;
    for (std::size_t i = sizeof(T); i-- > 0;)
        value = static_cast<T>((static_cast<std::uint64_t>(value) << 8) | static_cast<unsigned char>(bytes[at + i]));
    return value;
}

class SerializedReader {
public:
    SerializedReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    Mesh read(std::size_t index) {
        if (bytes_.size() < 8 || little<std::uint16_t>(bytes_, 0) != magic) fail("this is no serialized mesh of Mitsuba's");
        const std::size_t begin = place_of(index);
        if (begin > bytes_.size() - 4 || little<std::uint16_t>(bytes_, begin) != magic) fail("the table of meshes is damaged");
        Inflate packed(bytes_.substr(begin + 4), name_);
        return unpack(packed, little<std::uint16_t>(bytes_, begin + 2));
    }

private:
    [[noreturn]] void fail(const std::string& message) const { throw SceneError(name_, message); }

    std::size_t place_of(std::size_t index) const {
        const std::uint16_t version = little<std::uint16_t>(bytes_, 2);
        if (version != 3 && version != 4) fail("version " + std::to_string(version) + " of the format is not known");
        const std::size_t entry = version == 4 ? 8 : 4;
        const std::size_t table_end = bytes_.size() - 4, count = little<std::uint32_t>(bytes_, table_end);
        if (count > table_end / entry) fail("the table of meshes is damaged");
        if (index >= count) fail("has no mesh " + std::to_string(index) + ": there are " + std::to_string(count));
        const std::size_t at = table_end - (count - index) * entry;
        return version == 4 ? static_cast<std::size_t>(little<std::uint64_t>(bytes_, at)) : little<std::uint32_t>(bytes_, at);
    }

    template <class T>
    static T value(Inflate& packed) {
        char bytes[sizeof(T)];
        packed.read(bytes, sizeof(T));
        return little<T>({bytes, sizeof(T)}, 0);
    }

    double number(Inflate& packed) const {
        double result = 0;
        if (double_) {
            const auto bits = value<std::uint64_t>(packed);
            std::memcpy(&result, &bits, sizeof result);
        } else {
            const auto bits = value<std::uint32_t>(packed);
            float single = 0;
            std::memcpy(&single, &bits, sizeof single);
            result = static_cast<double>(single);
        }
        if (!std::isfinite(result)) fail("a number of the mesh is not finite");
        return result;
    }

    glm::dvec3 vector(Inflate& packed) const {
        const double x = number(packed), y = number(packed);
        return {x, y, number(packed)};
    }

    Mesh unpack(Inflate& packed, std::uint16_t version) {
        const auto flags = value<std::uint32_t>(packed);
        double_ = (flags & is_double) != 0;
        if (version == 4)
            while (value<std::uint8_t>(packed) != 0) {
            }
        const auto vertices = value<std::uint64_t>(packed), triangles = value<std::uint64_t>(packed);
        if (vertices > std::numeric_limits<std::uint32_t>::max() - 1 || vertices > packed.most_left() / 12 || triangles > max_triangles ||
            triangles > packed.most_left() / 12)
            fail("the file cannot hold " + std::to_string(vertices) + " vertices and " + std::to_string(triangles) + " triangles");
        Mesh mesh;
        for (std::uint64_t i = 0; i < vertices; ++i) mesh.positions.push_back(vector(packed));
        if ((flags & has_normals) != 0)
            for (std::uint64_t i = 0; i < vertices; ++i) mesh.normals.push_back(vector(packed));
        if ((flags & has_uvs) != 0)
            for (std::uint64_t i = 0; i < vertices; ++i) {
                const double u = number(packed);
                mesh.uvs.emplace_back(u, number(packed));
            }
        if ((flags & has_colours) != 0)
            for (std::uint64_t i = 0; i < vertices; ++i) mesh.colours.emplace_back(vector(packed));
        for (std::uint64_t i = 0; i < triangles; ++i) mesh.triangles.push_back(triangle(packed, vertices));
        mesh.smooth = (flags & is_flat) == 0;
        if ((flags & is_flat) != 0) mesh.normals.clear();
        return mesh;
    }

    glm::uvec3 triangle(Inflate& packed, std::uint64_t vertices) const {
        glm::uvec3 corners(0U);
        for (int k = 0; k < 3; ++k) {
            corners[k] = value<std::uint32_t>(packed);
            if (corners[k] >= vertices)
                fail("a triangle names vertex " + std::to_string(corners[k]) + ", but there are " + std::to_string(vertices));
        }
        return corners;
    }

    std::string_view bytes_;
    const std::string& name_;
    bool double_ = false;
};

}  // namespace

Mesh read_serialized(std::string_view bytes, std::size_t index, const std::string& name) {
    return SerializedReader(bytes, name).read(index);
}

}  // namespace pencil
