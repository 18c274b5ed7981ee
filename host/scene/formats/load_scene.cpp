#include "scene/formats/load_scene.h"

#include <algorithm>
#include <new>

#include "scene/scene_file.h"
#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace {

std::string readable_names(const std::vector<SceneFormat>& formats) {
    std::string names;
    for (const SceneFormat& format : formats)
        if (format.read) names += (names.empty() ? "" : ", ") + format.name;
    return names;
}

/// By content. What nothing recognises may be a damaged file of the format that its name tells, whose reader then says what is wrong.
const SceneFormat& format_of(const std::filesystem::path& file, std::string_view head, const std::vector<SceneFormat>& formats) {
    const std::string extension = file.extension().string();
    for (const SceneFormat& format : formats)
        if (format.recognises(head)) return format;
    for (const SceneFormat& format : formats)
        if (format.read && !extension.empty() && format.extension == extension) return format;
    throw SceneError(shown(file), "this is not a scene in a known format; known: " + readable_names(formats));
}

}  // namespace

Scene load_scene(const std::filesystem::path& file, const LoadOptions& options, const std::vector<SceneFormat>& formats) {
    const std::string head = read_head(file, head_bytes, shown(file));
    if (head.size() < head_bytes && trimmed(head).empty()) throw SceneError(shown(file), "the file is empty");
    const SceneFormat& format = format_of(file, head, formats);
    if (!format.read) throw SceneError(shown(file), "the format is " + format.name + ": " + format.advice);
    try {
        return format.read(file, options);
    } catch (const std::bad_alloc&) {
        throw MemoryError("reading " + shown(file) + " needs more memory than there is");
    }
}

Scene load_scene(const std::filesystem::path& file, const LoadOptions& options) { return load_scene(file, options, scene_formats()); }

}  // namespace pencil
