// Random bits from counters: the PCG hash of 32 bits (Jarzynski and Olano 2020), for one number and for packets.

#include "lib/packet.cl"

#define PCG_HASH(type, name)                                                 \
    static inline type name(type v) {                                               \
        type state = v * 747796405u + 2891336453u;                           \
        type word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u; \
        return (word >> 22u) ^ word;                                         \
    }

PCG_HASH(uint, hash_uint)
PCG_HASH(vuint, hash_packet)
