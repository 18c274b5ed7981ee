// Rays of the camera: from a pinhole, from points of a thin lens, or parallel ones.

#include "shared/camera.h"

typedef struct CameraRay {
    float4 origin, direction;  // w 0; the ray parameter is the depth along the optical axis
} CameraRay;

/// Through pixel position `at`, for sample `sample` of `sample_count`, whose points of the lens, in the unit disc, lie behind the offsets.
static inline CameraRay camera_ray(const Camera *camera, float2 at, global const float2 *offsets, int sample, int sample_count) {
    float4 d = camera->corner + at.x * camera->step_x + at.y * camera->step_y;
    CameraRay ray = {(float4)(camera->origin.xyz, 0.0f), (float4)(d.xyz, 0.0f)};
    if (!PENCIL_WIDE_CAMERA) return ray;
    float2 lens = offsets[sample_count + sample];
    float3 moved = lens.x * camera->lens_x.xyz + lens.y * camera->lens_y.xyz;
    ray.origin.xyz += at.x * camera->shift_x.xyz + at.y * camera->shift_y.xyz + moved;
    ray.direction.xyz -= moved * camera->lens_x.w;
    return ray;
}

/// The ray from where it comes nearer than the near distance no more, as lane `lane` of origins and directions.
static inline void store_camera_ray(const Camera *camera, CameraRay ray, int lane, float (*origin)[PENCIL_WIDTH],
                                    float (*direction)[PENCIL_WIDTH]) {
    float4 start = ray.origin + camera->near_clip * ray.direction;
    origin[0][lane] = start.x;
    origin[1][lane] = start.y;
    origin[2][lane] = start.z;
    direction[0][lane] = ray.direction.x;
    direction[1][lane] = ray.direction.y;
    direction[2][lane] = ray.direction.z;
}
