// Fresnel reflectance of smooth boundaries, unpolarised (Born and Wolf 1999, 1.5 and 14.2).

/// Of a dielectric with index eta, that of the far side over that of the near side; cosine > 0: of the angle on the near side. `refracted`:
/// cosine on the far side, 0 at total reflection.
static inline float fresnel_dielectric(float cosine, float eta, float *refracted) {
    float square = 1.0f - (1.0f - cosine * cosine) / (eta * eta);
    *refracted = 0.0f;
    if (square <= 0.0f) return 1.0f;
    float t = *refracted = sqrt(square);
    float s = (cosine - eta * t) / (cosine + eta * t), p = (t - eta * cosine) / (t + eta * cosine);
    return 0.5f * (s * s + p * p);
}

/// Of a conductor with complex index eta - i k, per channel.
static inline float3 fresnel_conductor(float cosine, float3 eta, float3 k) {
    float c = cosine * cosine, s = 1.0f - c;
    float3 t = eta * eta - k * k - s, q = sqrt(t * t + 4.0f * eta * eta * k * k);
    float3 a = sqrt(fmax(0.5f * (q + t), (float3)(0.0f)));
    float3 rs = (q + c - 2.0f * cosine * a) / (q + c + 2.0f * cosine * a);
    float3 x = c * q + s * s, y = 2.0f * cosine * s * a;
    return 0.5f * (rs + rs * (x - y) / fmax(x + y, (float3)(1e-30f)));
}

/// (1 - cosine)^5 (Schlick 1994).
static inline float schlick_weight(float cosine) {
    float m = clamp(1.0f - cosine, 0.0f, 1.0f), square = m * m;
    return square * square * m;
}
