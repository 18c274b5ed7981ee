// A camera in scene units for the film tests, built from kernels/shared/camera.h's definition alone.
#pragma once

#include "kernels/kernel_test.h"
#include "shared/camera.h"

namespace pencil::test {

struct TestCamera {
    Camera camera{};
    std::vector<float4> to_film;  // rows of the inverse of (step_x, step_y, corner)
    dvec3 origin, corner, step_x, step_y;
    dvec3 direction(double px, double py) const { return corner + px * step_x + py * step_y; }
};

inline TestCamera make_camera(const dvec3& origin, const dvec3& forward, const dvec3& up, double tan_half, int width, int height) {
    TestCamera out;
    const dvec3 f = glm::normalize(forward), right = glm::normalize(glm::cross(f, up)), above = glm::cross(right, f);
    out.origin = ref::as_float(origin);
    out.step_x = ref::as_float(right * (2.0 * tan_half / width));
    out.step_y = ref::as_float(-above * (2.0 * tan_half / width));
    out.corner = ref::as_float(f - out.step_x * (0.5 * width) - out.step_y * (0.5 * height));
    const glm::dmat3 rows = glm::transpose(glm::inverse(glm::dmat3(out.step_x, out.step_y, out.corner)));
    for (int k = 0; k < 3; ++k) out.to_film.push_back(to_float4(rows[k]));
    out.camera.origin = to_float4(out.origin);
    out.camera.corner = to_float4(out.corner);
    out.camera.step_x = to_float4(out.step_x);
    out.camera.step_y = to_float4(out.step_y);
    out.camera.width = width;
    out.camera.height = height;
    out.camera.near_clip = 0.0F;
    out.camera.far_clip = HUGE_VALF;
    return out;
}

}  // namespace pencil::test
