#include "surface/surface_pencils.h"

#include <algorithm>

namespace pencil {

void SurfacePencils::reserve(const std::shared_ptr<Device>& device, std::size_t more) {
    const std::size_t needed = static_cast<std::size_t>(count) + more;
    if (needed <= data.size()) return;
    SurfacePencils larger(device, static_cast<int>(std::max(needed, 2 * data.size())), n);
    if (count > 0) {
        larger.data.copy_from(data, 0, 0, static_cast<std::size_t>(count));
        larger.irradiance.copy_from(irradiance, 0, 0, static_cast<std::size_t>(count));
    }
    data = std::move(larger.data);
    irradiance = std::move(larger.irradiance);
}

}  // namespace pencil
