// Fields of pencils as OpenEXR files: an atlas of maps, whose header names the centres.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "image/read_image.h"
#include "options/pencil_field.h"
#include "options/render_options.h"

namespace pencil {

/// Bytes of the light of a field.
std::uint64_t field_bytes(int pencils, int map);

/// UsageError if such a field would make a larger file than read_field accepts.
void check_field_size(int pencils, int map);

/// `from`: what made the light, for the header. OutputError.
void write_field(const std::filesystem::path& path, const PencilField& field, const std::string& from);

/// SceneError naming the file if it is no field, damaged, or larger than fields may be.
PencilField read_field(const std::filesystem::path& path);

/// A file of which the light of single pencils is read: of those that `pencil bake` writes each map is a tile, of others whole rows of maps are read.
class FieldFile : public FieldSource {
public:
    /// SceneError as above; light is checked where it is read.
    explicit FieldFile(const std::filesystem::path& path);
    /// All but the light.
    const PencilField& head() const { return head_; }
    std::vector<float> light(int pencil) override;

private:
    std::filesystem::path path_;
    ImageParts parts_;
    PencilField head_;
};

/// RenderOptions::field from a file: the whole, or, where RenderOptions::field_pencils says so, what its light is read from as views need it.
void open_field(const std::filesystem::path& path, RenderOptions& options);

}  // namespace pencil
