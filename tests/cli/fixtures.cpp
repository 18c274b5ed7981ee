// Images are judged by oiiotool, so that a mistake shared by our writer and our reader shows.
#include "cli/fixtures.h"

#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "cli/run_program.h"

namespace pencil_test {

namespace fs = std::filesystem;

Folder::Folder() {
    std::string name = (fs::temp_directory_path() / "pencil-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp failed");
    path_ = name;
}

Folder::~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string Folder::write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return (path_ / name).string();
}

std::vector<std::string> Folder::names() const {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(path_)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string read_text(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string small_scene(bool lamp, bool floor) {
    std::string text = R"(<scene version="3.0.0">
    <default name="depth" value="-1"/>
    <integrator type="path"><integer name="max_depth" value="$depth"/></integrator>
    <sensor type="perspective">
        <float name="fov" value="60"/>
        <transform name="to_world"><lookat origin="0, -4, 1.5" target="0, 0, 0.5" up="0, 0, 1"/></transform>
        <film type="hdrfilm">
            <integer name="width" value="24"/><integer name="height" value="16"/>
            <rfilter type="box"/>
        </film>
    </sensor>
)";
    if (floor) {
        text += R"(    <shape type="rectangle" id="floor">
        <transform name="to_world"><scale x="2" y="2"/></transform>
        <bsdf type="twosided"><bsdf type="diffuse"><rgb name="reflectance" value="0.7, 0.5, 0.3"/></bsdf></bsdf>
    </shape>
    <shape type="rectangle" id="wall">
        <transform name="to_world"><rotate x="1" angle="90"/><scale x="2" y="2" z="2"/><translate y="2"/></transform>
        <bsdf type="twosided"><bsdf type="diffuse"><rgb name="reflectance" value="0.5, 0.5, 0.5"/></bsdf></bsdf>
    </shape>
)";
    }
    if (lamp) {
        text += R"(    <shape type="rectangle" id="lamp">
        <transform name="to_world"><rotate x="1" angle="180"/><scale x="0.5" y="0.5"/><translate z="1.9"/></transform>
        <bsdf type="diffuse"/>
        <emitter type="area"><rgb name="radiance" value="5, 5, 5"/></emitter>
    </shape>
)";
    }
    return text + "</scene>\n";
}

const std::vector<std::string>& quick() {
    static const std::vector<std::string> options{"--pencils", "16", "--map", "16", "--light-samples", "4", "--film-samples", "4"};
    return options;
}

double largest_difference(const fs::path& a, const fs::path& b) {
    const RunResult result = run({"oiiotool", "--fail", "1e-30", "--diff", a.string(), b.string()});
    const std::string key = "Max error  = ";
    const std::size_t found = result.out.find(key);
    if (found == std::string::npos) return result.out.find("PASS") != std::string::npos ? 0 : -1;
    return std::strtod(result.out.c_str() + found + key.size(), nullptr);
}

std::string image_info(const fs::path& file) { return run({"oiiotool", "--info", "-v", "--stats", file.string()}).out; }

}  // namespace pencil_test
