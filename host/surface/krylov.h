// The light that all reflections add up to, as a linear system: x = b + T x, T one reflection between the pencils of a set. Where most of the
// light is reflected hundreds of times, adding them up one by one takes thousands of steps; GMRES takes some tens (docs/equations.md).
#pragma once

#include <functional>
#include <glm/vec3.hpp>

#include "device/features.h"

namespace pencil {

/// target = T source.
using Transport = std::function<void(const Buffer<float4>& source, Buffer<float4>& target)>;

/// What is known of a solution, per channel.
struct KrylovReport {
    int applications = 0;           // of T
    glm::dvec3 spectral_radius{0};  // of T, estimated: the share of light that many reflections leave of each other
    glm::dvec3 error{0};            // of the solution, about: norm of the residual / (1 - spectral radius), relative to the solution
};

/// From this spectral radius on float does not tell whether reflections have a sum: the share that is lost is no larger than rounding.
constexpr double most_spectral_radius = 1.0 - 4e-6;

/// True where reflections of this spectral radius have no sum in some channel.
bool has_no_sum(const glm::dvec3& spectral_radius);

/// Adds the solution of x = b + T x to `total` (both of `count` pencils, rgb [W m^-2]), each channel by itself and with its own T. Restarted
/// GMRES until the error is below `tolerance` or float's rounding allows no better, or after `most` applications. A channel that has no sum
/// gets nothing.
KrylovReport solve_reflections(Kernels& kernels, const Transport& transport, const Buffer<float4>& b, int count, double tolerance, int most,
                               Buffer<float4>& total);

}  // namespace pencil
