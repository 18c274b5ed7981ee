// Points within the texels of a map, each texel's own: at random by its pencil's key, and such that points of successive turns fill it evenly.

#include "lib/hash.cl"
#include "lib/packet.cl"

/// Packet of texels at entry `first` of the map of pencil `key`: points of [-1, 1]^2 in texels (column, row) of n x n; shift: of all points, as
/// fractions of 2^32.
static inline void texel_points(uint key, int first, const int *column, const int *row, int n, uint seed, uint2 shift, vfloat *a,
                                vfloat *b) {
    vuint u = hash_packet((vuint)(hash_uint(key + hash_uint(seed))) + PACKET_AS_UINT(first + PACKET_LANES));
    vuint v = hash_packet(u) ^ shift.y;
    u ^= shift.x;
    *a = (PACKET_TO_FLOAT(PACKET_LOAD(column)) + PACKET_UNIT(u)) * (2.0f / n) - 1.0f;
    *b = (PACKET_TO_FLOAT(PACKET_LOAD(row)) + PACKET_UNIT(v)) * (2.0f / n) - 1.0f;
}
