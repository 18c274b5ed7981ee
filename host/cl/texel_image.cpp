#include "cl/texel_image.h"

#include <algorithm>
#include <vector>

#include "cl/cl_error.h"
#include "util/error.h"

namespace pencil {
namespace {

const cl::ImageFormat float_texels(CL_RGBA, CL_FLOAT);

bool has_format(const Device& device) {
    std::vector<cl::ImageFormat> formats;
    device.context().getSupportedImageFormats(CL_MEM_READ_ONLY, CL_MEM_OBJECT_IMAGE2D_ARRAY, &formats);
    return std::any_of(formats.begin(), formats.end(), [](const cl::ImageFormat& f) {
        return f.image_channel_order == float_texels.image_channel_order &&
               f.image_channel_data_type == float_texels.image_channel_data_type;
    });
}

}  // namespace

ImageLimits image_limits(const Device& device) {
    return cl_call([&] { return "asking " + device.info().name + " about images"; },
                   [&] {
                       const cl::Device& handle = device.cl_device();
                       if (!handle.getInfo<CL_DEVICE_IMAGE_SUPPORT>() || !has_format(device)) return ImageLimits();
                       return ImageLimits{handle.getInfo<CL_DEVICE_IMAGE2D_MAX_WIDTH>(), handle.getInfo<CL_DEVICE_IMAGE2D_MAX_HEIGHT>(),
                                          handle.getInfo<CL_DEVICE_IMAGE_MAX_ARRAY_SIZE>()};
                   });
}

TexelImage::TexelImage(std::shared_ptr<Device> device, std::size_t width, std::size_t height, std::size_t layers, const std::string& what)
    : device_(std::move(device)), size_{width, height, layers}, what_(what) {
    device_->reserve(bytes(), what_);
    try {
        image_ =
            cl_call([&] { return "allocating an image of " + format_bytes(bytes()) + " for " + what_ + " on " + device_->info().name; },
                    [&] {
                        device_->allocation_may_fail();
                        return cl::Image2DArray(device_->context(), CL_MEM_READ_ONLY, float_texels, layers, width, height, 0, 0);
                    });
    } catch (...) {
        device_->release(bytes());
        throw;
    }
}

TexelImage::~TexelImage() { device_->release(bytes()); }

void TexelImage::copy_from(const Buffer<float4>& texels) {
    if (texels.size() * sizeof(float4) < bytes()) throw std::out_of_range("an image of " + what_ + " has more texels than its buffer");
    cl_call([&] { return "copying " + format_bytes(bytes()) + " of " + what_ + " on " + device_->info().name; },
            [&] {
                cl::Event event;
                const std::array<cl::size_type, 3> origin{0, 0, 0};
                device_->queue().enqueueCopyBufferToImage(texels.handle(), image_, 0, origin, size_, nullptr, &event);
                device_->record("copy to image", "copy to image", event);
            });
}

}  // namespace pencil
