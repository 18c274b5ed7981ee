// Pencils on surfaces in device memory: what each knows of its place, and the irradiance there.
#pragma once

#include <tuple>
#include <vector>

#include "cl/buffer.h"
#include "shared/surface_pencil.h"

namespace pencil {

/// Work-group of kernels that sum the texels of one pencil per work-item: pencils are few and their work is long, so small groups keep all
/// units of a device busy.
constexpr std::size_t pencil_group = 8;

/// Pencils with their irradiance, and room for more; maps are not kept, only their sums.
struct SurfacePencils {
    SurfacePencils() = default;
    /// `room`: pencils to have memory for; `map_size`: n.
    SurfacePencils(const std::shared_ptr<Device>& device, int room, int map_size)
        : n(map_size),
          data(device, static_cast<std::size_t>(room), "surface pencils"),
          irradiance(device, static_cast<std::size_t>(room), "irradiance of surface pencils") {}
    /// These pencils.
    SurfacePencils(const std::shared_ptr<Device>& device, const std::vector<SurfacePencil>& pencils, int map_size)
        : SurfacePencils(device, static_cast<int>(pencils.size()), map_size) {
        data.write(pencils);
        count = static_cast<int>(pencils.size());
    }
    /// Makes room for `more` pencils behind the present ones.
    void reserve(const std::shared_ptr<Device>& device, std::size_t more);
    int texels() const { return n * n; }

    /// Arguments `pencils, first_pencil, pencil_count, n` of kernels.
    auto range(int first, int number) const { return std::tuple<const Buffer<SurfacePencil>&, int, int, int>(data, first, number, n); }

    int count = 0;
    int n = 0;  // width of the hemispherical map, a multiple of 4 [texels]
    Buffer<SurfacePencil> data;
    Buffer<float4> irradiance;  // rgb [W m^-2], of pencils that were summed
};

}  // namespace pencil
