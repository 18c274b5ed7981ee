// Irradiance of film pencils, each fitted with its neighbours on the lattice: a linear function of position, so that slopes stay and noise
// averages out.

/// Neighbours to each side.
#define SMOOTH_REACH 2
/// Share of the neighbours' weight that holds slopes at 0: decides where neighbours lie on one side or in a line.
#define SMOOTH_HOLD 1e-3f

/// launch : 1-D, one work-item per pixel
/// in     : pencils, pencil_at; facing.w: spacing at which a pencil was placed [pixels]; most_error: reuse_error at which a neighbour
/// counts
///          nothing
/// out    : irradiance[pencil]: rgb
kernel void smooth_irradiance(global const SurfacePencil *pencils, global const int *pencil_at, float most_error, int width, int height,
                              global float4 *irradiance) {
    int pixel = get_global_id(0);
    if (pixel >= width * height || pencil_at[pixel] < 0) return;
    global const SurfacePencil *own = pencils + pencil_at[pixel];
    int2 at = (int2)(pixel % width, pixel / width);
    int spacing = (int)own->facing.w;
    float3 x = own->position.xyz, n = own->normal.xyz, t, b;
    tangent_frame(n, &t, &b);
    // Moments of (1, s, u) and of the irradiance with them.
    float w0 = 0.0f, ws = 0.0f, wu = 0.0f, wss = 0.0f, wsu = 0.0f, wuu = 0.0f;
    float3 e0 = (float3)(0.0f), es = (float3)(0.0f), eu = (float3)(0.0f);
    for (int dy = -SMOOTH_REACH; dy <= SMOOTH_REACH; ++dy)
        for (int dx = -SMOOTH_REACH; dx <= SMOOTH_REACH; ++dx) {
            int2 p = at + spacing * (int2)(dx, dy);
            if (p.x < 0 || p.y < 0 || p.x >= width || p.y >= height) continue;
            int index = pencil_at[p.y * width + p.x];
            if (index < 0) continue;
            global const SurfacePencil *pencil = pencils + index;
            float distance = reuse_distance(pencil, x, n, INFINITY);
            if (distance == INFINITY) continue;
            float error = reuse_error(pencil, distance, n) + reuse_error(own, distance, n);
            float weight = fmax(1.0f - error / (2.0f * most_error), 0.0f);
            float3 step = pencil->position.xyz - x, e = pencil->irradiance.xyz;
            float s = dot(step, t), u = dot(step, b);
            w0 += weight;
            ws += weight * s;
            wu += weight * u;
            wss += weight * s * s;
            wsu += weight * s * u;
            wuu += weight * u * u;
            e0 += weight * e;
            es += weight * s * e;
            eu += weight * u * e;
        }
    float hold = SMOOTH_HOLD * (wss + wuu) + 1e-20f;
    wss += hold;
    wuu += hold;
    // First row of the inverse of the symmetric matrix [w0 ws wu; ws wss wsu; wu wsu wuu].
    float a = wss * wuu - wsu * wsu, c = wsu * wu - ws * wuu, d = ws * wsu - wss * wu;
    float determinant = w0 * a + ws * c + wu * d;
    float3 fitted = determinant > 1e-6f * w0 * wss * wuu ? (a * e0 + c * es + d * eu) / determinant : e0 / w0;
    irradiance[pencil_at[pixel]] = (float4)(fmax(fitted, (float3)(0.0f)), 0.0f);
}
