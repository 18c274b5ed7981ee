#include "bench/native/hash.h"
#include "bench/native/parallel.h"
#include "bench/native/rays.h"
#include "bench/native/surface.h"
#include "bench/native/write_surfel.h"

namespace pencil::native {
namespace {

/// Direction, in the frame of the normal, of the point (u, v) of a texel.
inline Vec3 texel_direction(int i, int n, float u, float v) {
    const float scale = 2.0F / static_cast<float>(n);
    const float a = (static_cast<float>(texel_x(i, n)) + u) * scale - 1.0F, b = (static_cast<float>(texel_y(i, n)) + v) * scale - 1.0F;
    const bool wide = std::abs(a) > std::abs(b);
    const float radius = wide ? a : b, angle = radius == 0.0F ? 0.0F : (wide ? b : a) / radius * 0.785398163F;
    const float s = radius * std::sin(angle), c = radius * std::cos(angle), x = wide ? c : s, y = wide ? s : c;
    return {x, y, std::sqrt(std::max(1.0F - x * x - y * y, 0.0F))};
}

}  // namespace

void trace_hemispheres(const SceneView& scene, const BvhView& bvh, const SurfacePencil* pencils, int count, int n, uint seed,
                       const glm::uvec2& shift, float* surfels, std::size_t capacity) {
    const int texels = n * n;  // a multiple of 16
    parallel_blocks(count, 4, [&](int begin, int end) {
        for (int p = begin; p < end; ++p) {
            const SurfacePencil& pencil = pencils[p];
            const float4v origin = load_point(pencil.position);
            const Vec3 normal = xyz(pencil.normal), facing = xyz(pencil.facing);
            Vec3 t, b;
            tangent_frame(normal, t, b);
            const unsigned key = hash_uint(pencil.key + hash_uint(seed));
            for (int first = 0; first < texels; first += lane_count) {
                vfloat x, y, z;
                for (int l = 0; l < lane_count; ++l) {
                    const unsigned u = hash_uint(key + static_cast<unsigned>(first + l)), v = hash_uint(u);
                    const Vec3 d = texel_direction(first + l, n, unit(u ^ shift.x), unit(v ^ shift.y));
                    x[l] = d.x * t.x + d.y * b.x + d.z * normal.x;
                    y[l] = d.x * t.y + d.y * b.y + d.z * normal.y;
                    z[l] = d.x * t.z + d.y * b.z + d.z * normal.z;
                }
                Rays rays(x, y, z);
                trace(rays, origin, pencil.plane, scene, bvh);
                const vint below = (x * facing.x + y * facing.y + z * facing.z) <= 0.0F;
                for (int l = 0; l < lane_count; ++l)
                    write_surfel(scene, {below[l] != 0 ? -1 : rays.triangle[l], rays.disparity[l]}, origin, float4v{x[l], y[l], z[l], 0.0F},
                                 surfels + static_cast<std::ptrdiff_t>(p) * texels + first + l, capacity);
            }
        }
    });
}

}  // namespace pencil::native
