// The environment behind all surfaces, as the camera sees it.

#include "lib/camera_ray.cl"
#include "lib/sky.cl"
#include "shared/camera.h"
#include "shared/film.h"

/// launch : 1-D, one work-item per pixel of the film
/// in     : slots[pixel * sample_count + sample]; offsets of the samples; the environment
/// out    : image[3 * pixel]: mean radiance of the pixel's samples that show nothing [W m^-2 sr^-1], 0 if there are none
kernel void show_sky(Camera camera, global const float2 *offsets, int sample_count, global const uchar *slots, SKY_PARAMETERS,
                     global float *image) {
    int pixel = get_global_id(0);
    if (pixel >= camera.width * camera.height) return;
    float2 corner = (float2)(pixel % camera.width, pixel / camera.width);
    float3 sum = (float3)(0.0f);
    int count = 0;
    for (int s = 0; s < sample_count; ++s) {
        if (slots[(size_t)pixel * sample_count + s] != NO_SURFEL) continue;
        CameraRay ray = camera_ray(&camera, corner + offsets[s], offsets, s, sample_count);
        sum += sky_seen(sky, sky_texels, normalize(ray.direction.xyz));
        ++count;
    }
    vstore3(count > 0 ? sum / count : sum, pixel, image);
}
