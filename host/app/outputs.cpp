// Two names can mean one file (./a.exr, links), so files are compared where they exist and canonical paths where they do not.
#include "app/outputs.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "options/layer.h"
#include "util/error.h"
#include "util/format.h"
#include "util/output_file.h"

namespace pencil {

namespace fs = std::filesystem;

bool same_file(const fs::path& a, const fs::path& b) {
    std::error_code error;
    if (fs::equivalent(a, b, error)) return true;
    const fs::path canonical_a = fs::weakly_canonical(fs::absolute(a, error), error);
    const fs::path canonical_b = fs::weakly_canonical(fs::absolute(b, error), error);
    return !error && canonical_a == canonical_b;
}

void check_outputs(const std::vector<fs::path>& images, const std::vector<fs::path>& others, const fs::path& scene) {
    std::vector<fs::path> files = images;
    for (const fs::path& file : files) image_format(file);
    std::copy_if(others.begin(), others.end(), std::back_inserter(files), [](const fs::path& file) { return !file.empty(); });
    for (auto file = files.begin(); file != files.end(); ++file) {
        if (same_file(*file, scene)) throw OutputError("cannot write " + file->string() + ": it is the scene");
        if (std::any_of(files.begin(), file, [&](const fs::path& earlier) { return same_file(earlier, *file); }))
            throw OutputError("cannot write " + file->string() + ": it is named twice");
        check_writable(*file);
    }
}

WrittenImages write_images(const std::vector<fs::path>& outputs, const LayeredImage& image, const Metadata& metadata, bool interrupted) {
    WrittenImages written;
    for (const fs::path& file : outputs) {
        const std::string name = photometric_word(file), shown = file.filename().string();
        const auto is_it = [&](const ImageLayer& layer) { return layer.name == name; };
        const bool missing = !name.empty() && std::none_of(image.layers.begin(), image.layers.end(), is_it);
        if (missing && interrupted && image_format(file) == ImageFormat::png) {
            written.warnings.push_back(fmt::format("{} is not written: interrupted before there was a layer {}", shown, name));
            continue;
        }
        if (missing && image_format(file) == ImageFormat::exr)
            written.warnings.push_back(interrupted ? fmt::format("{} has no layer {}: interrupted before there was one", shown, name)
                                                   : fmt::format("{} has no layer {}: --aov {} makes it", shown, name, name));
        const std::vector<std::string> warnings = write_image(file, image, metadata);
        written.warnings.insert(written.warnings.end(), warnings.begin(), warnings.end());
        written.files.push_back(file);
    }
    return written;
}

std::string interruption(const std::vector<fs::path>& written) {
    return written.empty() ? "interrupted; nothing is written" : "interrupted; the partial result is written";
}

std::uint64_t machine_memory() {
    return static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void check_film_memory(int width, int height, const std::vector<std::string>& aovs) {
    const int bounce_layers = 8;  // a guess that errs on the small side: what fails here could never have worked
    const int layers = 1 + static_cast<int>(aovs.size()) + (has_group(aovs, bounces_group) ? bounce_layers - 1 : 0);
    const double needed = static_cast<double>(width) * height * layers * 3 * sizeof(float);
    const std::uint64_t present = machine_memory();
    if (needed > static_cast<double>(present)) {
        throw MemoryError(fmt::format(
            "an image of {}x{} pixels with about {} layers needs {}, this machine has {}; try a smaller --resolution or --aov none", width,
            height, layers, format_size(static_cast<std::uint64_t>(needed)), format_size(present)));
    }
}

}  // namespace pencil
