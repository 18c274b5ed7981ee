// Packets of surfels. A work-item takes a block of PENCIL_BLOCK packets and runs through it pencil by pencil:
// neighbouring surfels meet the same texels, which then are in the nearest cache.

#include "lib/brdf.cl"
#include "lib/packet.cl"
#include "shared/surfel.h"

/// What the transport loops need of PENCIL_WIDTH surfels.
typedef struct SurfelPacket {
    vfloat x, y, z;
    vfloat nx, ny, nz;  // shading normal
    vfloat gx, gy, gz;  // geometric normal, loaded only where it may differ
    vint plane;
} SurfelPacket;

static inline float4 surfel_position(const SurfelPacket *p, int l) {
    return (float4)(LANE_FLOAT(p->x, l), LANE_FLOAT(p->y, l), LANE_FLOAT(p->z, l), 0.0f);
}

static inline SurfelPacket load_surfels(global const float *surfels, int capacity, int first) {
    global const float *s = surfels + first;
    SurfelPacket p;
    p.x = PACKET_LOAD(s + (size_t)SURFEL_X * capacity);
    p.y = PACKET_LOAD(s + (size_t)SURFEL_Y * capacity);
    p.z = PACKET_LOAD(s + (size_t)SURFEL_Z * capacity);
    p.nx = PACKET_LOAD(s + (size_t)SURFEL_NX * capacity);
    p.ny = PACKET_LOAD(s + (size_t)SURFEL_NY * capacity);
    p.nz = PACKET_LOAD(s + (size_t)SURFEL_NZ * capacity);
    if (PENCIL_SMOOTH || PENCIL_RELIEF) {
        p.gx = PACKET_LOAD(s + (size_t)SURFEL_GX * capacity);
        p.gy = PACKET_LOAD(s + (size_t)SURFEL_GY * capacity);
        p.gz = PACKET_LOAD(s + (size_t)SURFEL_GZ * capacity);
    }
    p.plane = PACKET_LOAD((global const int *)(s + (size_t)SURFEL_PLANE * capacity));
    return p;
}

/// |x| |v| cos of the angle between the shading normals and -v; 0 where -v is not on the seen side of both normals.
static inline vfloat packet_cosine_towards(const SurfelPacket *p, vfloat vx, vfloat vy, vfloat vz) {
    vfloat c = -fma(p->nx, vx, fma(p->ny, vy, p->nz * vz));
    c = fmax(c, (vfloat)(0.0f));
    if (PENCIL_SMOOTH || PENCIL_RELIEF) c = select(c, (vfloat)(0.0f), PACKET_MASK(fma(p->gx, vx, fma(p->gy, vy, p->gz * vz)) >= 0.0f));
    return c;
}

/// Adds (accumulate) or writes a packet of rgb to rgb_buffer[3][capacity].
static inline void store_rgb(global float *rgb_buffer, int capacity, int first, vfloat r, vfloat g, vfloat b, int accumulate) {
    global float *out = rgb_buffer + first;
    if (accumulate) {
        r += PACKET_LOAD(out);
        g += PACKET_LOAD(out + (size_t)capacity);
        b += PACKET_LOAD(out + 2 * (size_t)capacity);
    }
    PACKET_STORE(r, out);
    PACKET_STORE(g, out + (size_t)capacity);
    PACKET_STORE(b, out + 2 * (size_t)capacity);
}

/// Scatters irradiance (operator K): radiance that the surfels reflect [W m^-2 sr^-1] to rgb_buffer[3][capacity], as store_rgb.
static inline void scatter_irradiance(global const float *surfels, int capacity, int first, vfloat r, vfloat g, vfloat b,
                                      global float *rgb_buffer, int accumulate) {
    global const float *s = surfels + first;
    r = brdf_reflect_packet(PACKET_LOAD(s + (size_t)SURFEL_ALBEDO_R * capacity), r);
    g = brdf_reflect_packet(PACKET_LOAD(s + (size_t)SURFEL_ALBEDO_G * capacity), g);
    b = brdf_reflect_packet(PACKET_LOAD(s + (size_t)SURFEL_ALBEDO_B * capacity), b);
    store_rgb(rgb_buffer, capacity, first, r, g, b, accumulate);
}
