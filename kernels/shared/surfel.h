// Surfels, structure of arrays in one float buffer: field f of surfel i is at f * capacity + i; capacity is a multiple of 128.
// A surfel that saw nothing has plane -1, zero normal, zero albedo.
#pragma once

#define SURFEL_X 0  // position [scene units]
#define SURFEL_Y 1
#define SURFEL_Z 2
#define SURFEL_NX 3  // unit shading normal on the side that was seen
#define SURFEL_NY 4
#define SURFEL_NZ 5
#define SURFEL_PLANE 6     // index into planes as int bits, -1 if nothing was seen
#define SURFEL_ALBEDO_R 7  // diffuse reflectance of the side that was seen
#define SURFEL_ALBEDO_G 8
#define SURFEL_ALBEDO_B 9
#define SURFEL_MATERIAL 10  // index into materials as int bits; ~index if the back was seen; material of nothing: PENCIL_NO_MATERIAL
#define SURFEL_GX 11        // unit geometric normal on the side that was seen
#define SURFEL_GY 12
#define SURFEL_GZ 13
#define SURFEL_FIELDS 14  // that every surfel has

// Of scenes with lobes, an environment or textured emitters (Features::outgoing, on the device PENCIL_OUTGOING):
#define SURFEL_OX 14  // unit direction from the surface to where it was seen from; where nothing was seen against the ray
#define SURFEL_OY 15
#define SURFEL_OZ 16
// What a chain of mirrors and glossy surfaces does to light from here on its way to where the surfel counts (follow_surfels.cl); 1 without
// one. The albedo includes it.
#define SURFEL_TR 17
#define SURFEL_TG 18
#define SURFEL_TB 19
#define SURFEL_SHARE 20  // of sampled emitters' light that such a chain carries, the rest are light samples'; -1: there is no chain
// Lobes of the surface, without that factor.
#define SURFEL_SR 21  // factor of reflection; principled: base colour
#define SURFEL_SG 22
#define SURFEL_SB 23
#define SURFEL_ALPHA 24     // roughness; -1: what was seen has no lobes
#define SURFEL_METALLIC 25  // principled

// Of scenes with emitters whose radiance is a texture (Features::glow, on the device PENCIL_GLOW), which have those fields, too:
#define SURFEL_ER 26  // emitted radiance of the side that was seen [W m^-2 sr^-1]
#define SURFEL_EG 27
#define SURFEL_EB 28

#define SURFEL_FIELDS_OUTGOING 26
#define SURFEL_FIELDS_GLOW 29

#define PENCIL_NO_MATERIAL 0x7fffffff

#ifdef __OPENCL_C_VERSION__
/// A field that is an index, at field * capacity + surfel: never read or written as a float, as which it may be denormal or NaN.
#define SURFEL_INT(surfels, at) (((global int *)(surfels))[at])
#define SURFEL_CONST_INT(surfels, at) (((global const int *)(surfels))[at])
#endif
