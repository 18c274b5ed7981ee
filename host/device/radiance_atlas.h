// Which form of the radiance maps projection looks up (kernels/lib/atlas.cl): the buffer, or a copy of it as an image.
#pragma once

#include <memory>
#include <string>

#include "cl/texel_image.h"
#include "device/features.h"
#include "device/pencil_set.h"
#include "options/render_options.h"

namespace pencil {

/// Whether maps of `shape` of so many pencils are looked up as an image on a device. UsageError if that was asked for and the device has no
/// such images.
bool atlas_is_image(Atlas asked, const Device& device, const MapShape& shape, int pencils);

/// One sentence for --explain.
std::string explain_atlas(const Features& features);

/// The image, with a layer for each pencil. Buffers stay for all that makes and changes maps.
class RadianceAtlas {
public:
    explicit RadianceAtlas(std::shared_ptr<Device> device) : device_(std::move(device)) {}

    /// A copy of the maps of a set as they are now.
    const TexelImage& image_of(const PencilSet& set);

private:
    std::shared_ptr<Device> device_;
    std::unique_ptr<TexelImage> image_;
};

}  // namespace pencil
