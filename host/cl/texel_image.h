// Layers of float4 texels as an image: what the device interpolates by itself. A copy of a buffer, counted against the device's plan.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "cl/buffer.h"
#include "shared/types.h"

namespace pencil {

/// Greatest sizes of such images; all 0 where a device has none.
struct ImageLimits {
    std::size_t width = 0, height = 0, layers = 0;
    bool hold(std::size_t w, std::size_t h, std::size_t n) const { return w <= width && h <= height && n <= layers; }
};
ImageLimits image_limits(const Device& device);

class TexelImage {
public:
    TexelImage(std::shared_ptr<Device> device, std::size_t width, std::size_t height, std::size_t layers, const std::string& what);
    ~TexelImage();
    TexelImage(const TexelImage&) = delete;
    TexelImage& operator=(const TexelImage&) = delete;

    /// Copies as many texels as the image has from a buffer, on the device: rows, then layers, one after the other.
    void copy_from(const Buffer<float4>& texels);

    std::size_t width() const { return size_[0]; }
    std::size_t height() const { return size_[1]; }
    std::size_t layers() const { return size_[2]; }
    const cl::Image2DArray& handle() const { return image_; }

private:
    std::size_t bytes() const { return size_[0] * size_[1] * size_[2] * sizeof(float4); }
    std::shared_ptr<Device> device_;
    std::array<std::size_t, 3> size_;
    std::string what_;
    cl::Image2DArray image_;
};

}  // namespace pencil
