// Judges, before any work is done, whether the results can be stored: in files, and in memory until then.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "image/write_image.h"

namespace pencil {

/// True if both names mean one file, whether it exists or not.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// UsageError for an extension that cannot be written; OutputError for a folder that cannot be written to, a file named twice, or one that
/// is the scene. Of `others`, files that are no images, some may be empty.
void check_outputs(const std::vector<std::filesystem::path>& images, const std::vector<std::filesystem::path>& others,
                   const std::filesystem::path& scene);

struct WrittenImages {
    std::vector<std::filesystem::path> files;
    std::vector<std::string> warnings;
};

/// Writes the image to all files. Of an `interrupted` run, files that show a layer which was not reached are left out, with a warning each.
WrittenImages write_images(const std::vector<std::filesystem::path>& outputs, const LayeredImage& image, const Metadata& metadata,
                           bool interrupted);

/// What is said of an interrupted run.
std::string interruption(const std::vector<std::filesystem::path>& written);

/// Bytes of memory that this machine has.
std::uint64_t machine_memory();

/// MemoryError if the image's layers alone exceed this machine's memory.
void check_film_memory(int width, int height, const std::vector<std::string>& aovs);

}  // namespace pencil
