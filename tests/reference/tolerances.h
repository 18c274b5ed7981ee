// Every tolerance of the tests, with its reason. A test that needs another number adds it here.
#pragma once

namespace pencil::tolerance {

constexpr double float_epsilon = 5.9604645e-8;  // half a unit in the last place of 1.0F

/// A few dozen float operations, none of which cancels: octahedral coordinates, a cosine, one weight.
constexpr double few_operations = 4e-6;
/// Accumulations over some hundred terms of one sign in float, each term itself `few_operations` good.
constexpr double accumulation = 2e-5;
/// cos^beta with beta up to 512 multiplies the relative error of the cosine by beta: 512 * 4 * float_epsilon.
constexpr double power_512 = 1.3e-4;
/// Signed volumes of a ray and a triangle's edge, relative to the product of the three lengths: a ray nearer to an edge than this may
/// fall on either side of it in float arithmetic.
constexpr double edge_tie = 2e-6;
/// Distances along one ray that agree to this are a tie: float t of two triangles that meet there.
constexpr double depth_tie = 4e-6;
/// A plane nearer to the centre of projection than this [normalised scene units, coordinates up to 1] is within the rounding error of the
/// coordinates and is not seen by it. The kernels may decide freely between an eighth and eight times this.
constexpr double plane_through_centre = 1e-6;
constexpr double plane_through_centre_slack = 8.0;

/// A coordinate up to 1 after one multiply-add in float, and a unit in the last place for the input.
constexpr double position = 2e-7;
/// Decisions of surface pencils (radius, slope, normal, horizon, order of weights), relative: a surfel nearer to one than this may be
/// decided either way in float. Few operations on differences of positions that are 1e-3 and more apart: 1e-3 loses three digits.
constexpr double decision = 1e-4;
/// A quotient of sums of products of three that may cancel down to a hundredth.
constexpr double quotient = 4e-5;
/// Integrals by some thousand strata: 4096 directions about a point, 16384 points of an emitter. Measured: 3e-3.
constexpr double strata = 1e-2;
/// Least squares by moments about a mean in float, of up to 49 pencils: what cancels loses up to three digits (the hold on slopes is 1e-3 of
/// the moments) where they lie in a line, and another where they lie to one side. Measured: 4.1e-4.
constexpr double fit = 6e-4;
/// Slopes of at most 1 that the hold (SMOOTH_HOLD, 1e-3 of the sum of both moments) lowers where neighbours lie almost in a line.
constexpr double held = 0.02;
/// A weighted mean of linear functions whose terms are ten times their sum.
constexpr double interpolation = 1e-4;
/// Bilinear look-ups by filtering hardware, relative to the greatest difference between the four texels: both interpolation weights may be cut to 8 bits.
constexpr double image_weights = 2.0 / 256;

}  // namespace pencil::tolerance
