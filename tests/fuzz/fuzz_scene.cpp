// Any bytes as scene XML, beside two small meshes that it may name: an error, or a scene that can be flattened for the device.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "fuzz/check_mesh.h"
#include "pencils/flat_scene.h"
#include "pencils/light_samples.h"
#include "scene/formats/load_scene.h"

namespace {

namespace fs = std::filesystem;
using pencil::fuzz::require;

void write(const fs::path& file, const std::string& content) {
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    stream << content;
    require(stream.good());
}

/// A folder of this process, in memory where the system has such a place, with the meshes that the seeds name.
struct Folder {
    Folder() : path((fs::is_directory("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path()) / ("pencil_fuzz_" + pid())) {
        fs::create_directories(path / "meshes");
        write(path / "meshes" / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nf 1//1 2//1 3//1\nf 1 2 4\n");
        write(path / "meshes" / "b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n");
        write(path / "meshes" / "a.ply",
              "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
              "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    static std::string pid() { return std::to_string(getpid()); }

    fs::path path;
};

void load(const std::string& text) {
    static const Folder folder;
    const fs::path file = folder.path / "scene.xml";
    write(file, text);
    const pencil::Scene scene = pencil::load_scene(file, {});
    for (const glm::dvec3& position : scene.positions) require(pencil::fuzz::is_finite(position));
    for (const pencil::Triangle3& t : scene.triangles) {
        require(t.shape < scene.shapes.size());
        require(t.material < scene.materials.size());
        for (int k = 0; k < 3; ++k) require(t.corners[k] < scene.positions.size());
    }
    require(scene.normals.size() == scene.positions.size());
    require(scene.uvs.empty() || scene.uvs.size() == scene.positions.size());
    const auto forms = pencil::choose_light_forms(scene, false, false);
    const pencil::FlatScene flat = pencil::flatten(scene, forms, 0, 0);
    for (const pencil::float4& plane : flat.planes) require(pencil::fuzz::is_finite(glm::dvec3(plane)));
    for (const pencil::LightSample& sample : pencil::sample_lights(scene, flat, forms, 4, 0))
        require(pencil::fuzz::is_finite(glm::dvec3(sample.position)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    pencil::fuzz::accept_scene_errors([&] { load(text); });
    return 0;
}
