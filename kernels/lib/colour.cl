// Linear sRGB.

/// Rec. 709 luminance, as of image/colour.h.
static inline float luminance(float3 rgb) { return dot(rgb, (float3)(0.2126f, 0.7152f, 0.0722f)); }

static inline float largest(float3 rgb) { return fmax(rgb.x, fmax(rgb.y, rgb.z)); }
