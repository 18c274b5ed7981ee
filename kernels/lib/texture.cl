// Textures at a point of a surface.

#include "lib/colour.cl"
#include "shared/texture.h"

/// Coordinates end here [texels]: beyond it floats have no fractions left to speak of.
#define TEXTURE_FAR 1e6f

/// Texel index of a coordinate in texels that may lie outside.
static inline int wrap_texel(int i, int size, int wrap) {
    if (wrap == TEXTURE_CLAMP) return clamp(i, 0, size - 1);
    int period = wrap == TEXTURE_MIRROR ? 2 * size : size;
    i -= (int)floor((float)i / period) * period;
    i = clamp(i, 0, period - 1);  // the quotient is rounded
    return i < size ? i : 2 * size - 1 - i;
}

static inline float4 bitmap_texel(global const TextureRow *t, global const half *texels, int x, int y) {
    size_t at = (size_t)t->first + (size_t)wrap_texel(y, t->height, t->wrap_v) * t->width + wrap_texel(x, t->width, t->wrap_u);
    return vload_half4(at, texels);
}

/// The four texels about a place, by column and row; f: of the way to the later ones.
typedef struct Patch {
    float4 t00, t10, t01, t11;
    float2 f;
} Patch;

/// at: in texels.
static inline Patch bitmap_patch(global const TextureRow *t, global const half *texels, float2 at) {
    float2 low = floor(at - 0.5f);
    int x = (int)low.x, y = (int)low.y;
    Patch p = {bitmap_texel(t, texels, x, y), bitmap_texel(t, texels, x + 1, y), bitmap_texel(t, texels, x, y + 1),
               bitmap_texel(t, texels, x + 1, y + 1), at - 0.5f - low};
    return p;
}

/// (u, v) in texels.
static inline float2 in_texels(global const TextureRow *t, float2 uv) {
    return clamp(uv * (float2)(t->width, t->height), -TEXTURE_FAR, TEXTURE_FAR);
}

/// Colour and opacity of a bitmap at (u, v), row 0 from v = 0 on.
static inline float4 bitmap_value(global const TextureRow *t, global const half *texels, float2 uv) {
    float2 at = in_texels(t, uv);
    if (t->nearest) return bitmap_texel(t, texels, (int)floor(at.x), (int)floor(at.y));
    Patch p = bitmap_patch(t, texels, at);
    return mix(mix(p.t00, p.t10, p.f.x), mix(p.t01, p.t11, p.f.x), p.f.y);
}

/// A point of triangle `triangle` at barycentric weights w, with texture coordinates uv.
typedef struct TexturePoint {
    float2 uv;
    float3 w;
    int triangle;
} TexturePoint;

/// rgb: colour, w: opacity.
static inline float4 texture_value(global const TextureRow *t, global const half *texels, const TexturePoint *p) {
    if (t->kind == TEXTURE_VERTEX_COLOURS) {
        size_t at = (size_t)t->first + 3 * (size_t)p->triangle;
        return p->w.x * vload_half4(at, texels) + p->w.y * vload_half4(at + 1, texels) + p->w.z * vload_half4(at + 2, texels);
    }
    float3 q = (float3)(p->uv, 1.0f);
    float2 uv = (float2)(dot(t->row_u.xyz, q), dot(t->row_v.xyz, q));
    if (t->kind == TEXTURE_BITMAP) return bitmap_value(t, texels, uv);
    float2 squares = floor(2.0f * (uv - floor(uv)));
    return t->colour[squares.x == squares.y ? 0 : 1];
}

/// The value of an optional texture, 1 without one.
static inline float4 texture_or_one(int texture, global const TextureRow *textures, global const half *texels, const TexturePoint *p) {
    return texture >= 0 ? texture_value(textures + texture, texels, p) : (float4)(1.0f);
}

/// Derivatives by u and v of the luminance of a bitmap's bilinear filter; other textures have none.
static inline float2 texture_slope(global const TextureRow *t, global const half *texels, const TexturePoint *p) {
    if (t->kind != TEXTURE_BITMAP) return (float2)(0.0f);
    float3 q = (float3)(p->uv, 1.0f);
    Patch at = bitmap_patch(t, texels, in_texels(t, (float2)(dot(t->row_u.xyz, q), dot(t->row_v.xyz, q))));
    float a = luminance(at.t00.xyz), b = luminance(at.t10.xyz), c = luminance(at.t01.xyz), d = luminance(at.t11.xyz);
    float by_column = t->width * mix(b - a, d - c, at.f.y), by_row = t->height * mix(c - a, d - b, at.f.x);
    return by_column * t->row_u.xy + by_row * t->row_v.xy;
}
