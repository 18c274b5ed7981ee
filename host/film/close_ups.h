// A finer look at the pixels that hold most of an image's noise: lamps that are smaller than a pixel, what a lamp lights just beside it. About
// each of their visibility samples lie several surfels, and emission and direct light of the sample are the means of theirs. Launchers of
// kernels/close_ups.cl and average_close_ups.cl.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "device/device_scene.h"
#include "device/features.h"
#include "device/surfels.h"
#include "device/turn.h"

namespace pencil {

struct CloseUps {
    int each = 0;        // surfels about a sample; 0: there are no close-ups
    int samples = 0;     // of a pixel
    Buffer<int> pixels;  // every sample of which has a surfel
    Surfels surfels;     // `each` for each sample of each of them
};

/// The film whose samples are looked at: `offsets` as of trace_film.
struct FilmSamples {
    const Camera& camera;
    const Buffer<glm::vec2>& offsets;
    int count;
};

/// Close-ups of these pixels, of a film of so many surfels: about as many as it has, or a few thousand, at most. None without a hierarchy.
CloseUps look_closely(Kernels& kernels, const DeviceScene& scene, const FilmSamples& film, const std::vector<int>& pixels, int film_surfels,
                      const Turn& turn);

/// What the film's surfels of those samples show becomes the mean of `values`, [3][capacity of the close-ups]; of_film[3][capacity of the film].
void average_close_ups(Kernels& kernels, const CloseUps& close_ups, const Buffer<int>& first_surfel, const Buffer<float>& values,
                       Buffer<float>& of_film, int film_capacity);

}  // namespace pencil
