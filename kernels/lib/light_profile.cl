// Lights whose intensity depends on the direction by a table (pencils/profile_table.cpp).

#include "shared/light.h"

/// Intensity along unit direction d in terms of the light's own; axis: the light's; first: texel of its table.
static inline float profile_share(global const half *tables, int first, float3 axis, float3 d) {
    float3 x = vload_half4(first, tables).xyz, y = cross(axis, x);
    float row = acos(clamp(dot(axis, d), -1.0f, 1.0f)) * (M_1_PI_F * (PROFILE_ROWS - 1));
    float turn = atan2(dot(y, d), dot(x, d)) * (0.5f * M_1_PI_F), column = (turn - floor(turn)) * PROFILE_COLUMNS;
    int r = min((int)row, PROFILE_ROWS - 2), c = min((int)column, PROFILE_COLUMNS - 1), next = (c + 1) % PROFILE_COLUMNS;
    size_t a = (size_t)first + 1 + c * PROFILE_ROWS + r, b = (size_t)first + 1 + next * PROFILE_ROWS + r;
    float v = row - r;
    float one = mix(vload_half(4 * a, tables), vload_half(4 * a + 4, tables), v);
    float two = mix(vload_half(4 * b, tables), vload_half(4 * b + 4, tables), v);
    return mix(one, two, column - c);
}
