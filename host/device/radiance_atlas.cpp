#include "device/radiance_atlas.h"

#include <fmt/format.h>

#include "util/error.h"

namespace pencil {

bool atlas_is_image(Atlas asked, const Device& device, const MapShape& shape, int pencils) {
    if (asked == Atlas::buffer || (asked == Atlas::automatic && !device.profile().atlas_image)) return false;
    const ImageLimits limits = image_limits(device);
    const auto width = static_cast<std::size_t>(PENCIL_TILE_STRIDE(shape.n)), height = static_cast<std::size_t>(shape.stored()) / width;
    if (limits.hold(width, height, static_cast<std::size_t>(pencils))) return true;
    if (asked == Atlas::automatic) return false;
    throw UsageError(fmt::format("--atlas image: {} images of {}x{} texels are needed, and {} holds {} of {}x{}; take --atlas buffer",
                                 pencils, width, height, device.info().name, limits.layers, limits.width, limits.height));
}

std::string explain_atlas(const Features& features) {
    return features.atlas_image ? "radiance maps are looked up as an image, which the device filters"
                                : "radiance maps are looked up in a buffer; left out: their copy as an image";
}

const TexelImage& RadianceAtlas::image_of(const PencilSet& set) {
    const auto width = static_cast<std::size_t>(PENCIL_TILE_STRIDE(set.maps->n)),
               height = static_cast<std::size_t>(set.maps->stored()) / width, layers = static_cast<std::size_t>(set.maps->count);
    if (!image_ || image_->width() != width || image_->height() != height || image_->layers() != layers) {
        image_.reset();  // before the new one asks for memory
        image_ = std::make_unique<TexelImage>(device_, width, height, layers, "radiance maps as an image");
    }
    image_->copy_from(set.radiance);
    return *image_;
}

}  // namespace pencil
