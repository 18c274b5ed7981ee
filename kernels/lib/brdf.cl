// Reflection of light that is known by its irradiance E alone, not by its directions, for a surface of this albedo: exact for what scatters
// evenly; for others it is their base (bsdf.cl) in even light. It stands in three forms, each with the order of multiplications that its
// callers were measured and compared with, since every other order rounds differently.

#include "lib/packet.cl"

/// Radiance albedo E / pi [W m^-2 sr^-1] of one point.
static inline float3 brdf_reflect(float3 albedo, float3 irradiance) { return albedo * irradiance * M_1_PI_F; }

/// The same for one channel of a packet: 1 / pi goes to the albedo, which is there before the irradiance is.
static inline vfloat brdf_reflect_packet(vfloat albedo, vfloat irradiance) { return irradiance * (M_1_PI_F * albedo); }

/// sum plus radiosity albedo E [W m^-2], pi times the radiance, for sums over texels of cosine-weighted solid angle pi / n^2, where pi
/// cancels. The sum is in the same expression, so that compilers may fuse product and sum.
static inline float4 brdf_add_radiosity(float4 sum, float4 albedo, float4 irradiance) { return sum + irradiance * albedo; }
