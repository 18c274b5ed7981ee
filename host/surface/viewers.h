// Who sees surfels.
#pragma once

#include <optional>
#include <tuple>

#include "surface/surface_pencils.h"

namespace pencil {

/// Pencils of a set from `first` on, by all their texels or so many other rays.
struct Viewers {
    const SurfacePencils& pencils;
    int first;
    int rays = 0;
    int rays_each() const { return rays > 0 ? rays : pencils.texels(); }
};

/// Arguments `viewers, first_viewer, texels` of kernels; nobody: texels is 0.
class ViewerArguments {
public:
    ViewerArguments(const std::shared_ptr<Device>& device, const std::optional<Viewers>& viewers)
        : nobody_(viewers ? Buffer<SurfacePencil>() : Buffer<SurfacePencil>(device, 1, "no viewers")),
          pencils_(viewers ? viewers->pencils.data : nobody_),
          first_(viewers ? viewers->first : 0),
          texels_(viewers ? viewers->rays_each() : 0) {}
    std::tuple<const Buffer<SurfacePencil>&, int, int> list() const { return {pencils_, first_, texels_}; }

private:
    Buffer<SurfacePencil> nobody_;
    const Buffer<SurfacePencil>& pencils_;
    int first_, texels_;
};

}  // namespace pencil
