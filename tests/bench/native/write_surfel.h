// A surfel from a hit (kernels/lib/surfel.cl), for scenes without vertex normals.
#pragma once

#include "bench/native/triangle.h"

namespace pencil::native {

inline float as_float(int value) {
    float out;
    std::memcpy(&out, &value, sizeof out);
    return out;
}

inline void write_surfel(const SceneView& scene, const Hit& hit, float4v cop, float4v direction, float* s, std::size_t capacity) {
    float values[SURFEL_FIELDS] = {};
    if (hit.triangle < 0) {
        values[SURFEL_PLANE] = as_float(-1);
        values[SURFEL_MATERIAL] = as_float(PENCIL_NO_MATERIAL);
    } else {
        const Triangle& t = scene.triangles[hit.triangle];
        const float4& plane = scene.planes[t.plane];
        const Material& material = scene.materials[t.material];
        const float4v p = cop + direction / hit.disparity;
        const bool front = plane_ahead(plane, cop) < 0.0F;
        const float side = front ? 1.0F : -1.0F, reflects = front || material.albedo.w != 0.0F ? 1.0F : 0.0F;
        for (int c = 0; c < 3; ++c) {
            values[SURFEL_X + c] = p[c];
            values[SURFEL_NX + c] = values[SURFEL_GX + c] = side * plane[c];
            values[SURFEL_ALBEDO_R + c] = reflects * material.albedo[c];
        }
        values[SURFEL_PLANE] = as_float(t.plane);
        values[SURFEL_MATERIAL] = as_float(front ? t.material : ~t.material);
    }
    for (int f = 0; f < SURFEL_FIELDS; ++f) s[static_cast<std::size_t>(f) * capacity] = values[f];
}

}  // namespace pencil::native
