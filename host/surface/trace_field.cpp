#include "surface/trace_field.h"

#include "pencils/low_discrepancy.h"

namespace pencil {

namespace {

/// RAY_BLOCK of kernels/lib/octahedral.cl.
constexpr int ray_block = 4;

}  // namespace

void trace_field(Kernels& kernels, const DeviceScene& scene, const SurfacePencils& pencils, int first, int count, const TexelPoints& points,
                 Surfels& surfels) {
    surfels.count = count * pencils.texels();
    kernels.get("trace_field")
        .args(pencils.data, first, count, pencils.n, points.seed, sobol_2d(points.turn), scene.hierarchy(), scene.surfaces(),
              surfels.store())
        .run(kernels.packets(surfels.count), "trace field");
}

glm::ivec2 field_texel(int i, int n) {
    const int block = i / (ray_block * ray_block), lane = i % (ray_block * ray_block), across = n / ray_block;
    return ray_block * glm::ivec2(block % across, block / across) + glm::ivec2(lane % ray_block, lane / ray_block);
}

}  // namespace pencil
