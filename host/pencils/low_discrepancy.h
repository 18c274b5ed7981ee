// Point sequences and hashed random numbers, the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace pencil {

/// Finaliser of SplitMix64 (Steele, Lea, Flood 2014): a bijective hash of 64 bits.
inline std::uint64_t hash64(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

/// Counter-based random numbers in [0, 1): number `index` of stream (seed, stream).
inline double random_unit(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
    return static_cast<double>(hash64(hash64(hash64(seed) ^ stream) ^ index) >> 11) * 0x1.0p-53;
}

inline double fraction(double x) { return x - std::floor(x); }

/// Additive recurrence of the generalised golden ratios (Roberts 2018): R2, R3 and R4, shifted.
inline glm::dvec2 r2_sequence(std::uint64_t index, const glm::dvec2& shift) {
    constexpr double g = 1.32471795724474602596;
    const double i = static_cast<double>(index);
    return {fraction(shift.x + i * (1.0 / g)), fraction(shift.y + i * (1.0 / (g * g)))};
}
inline glm::dvec3 r3_sequence(std::uint64_t index, const glm::dvec3& shift) {
    constexpr double g = 1.22074408460575947536;
    const double i = static_cast<double>(index);
    return {fraction(shift.x + i * (1.0 / g)), fraction(shift.y + i * (1.0 / (g * g))), fraction(shift.z + i * (1.0 / (g * g * g)))};
}
inline glm::dvec4 r4_sequence(std::uint64_t index, const glm::dvec4& shift) {
    constexpr double g = 1.16730397826141868426;
    const double i = static_cast<double>(index), a = 1.0 / g;
    return {fraction(shift.x + i * a), fraction(shift.y + i * (a * a)), fraction(shift.z + i * (a * a * a)),
            fraction(shift.w + i * (a * a * a * a))};
}

/// The first two dimensions of Sobol's sequence (1967), a (0, 2)-sequence in base 2, as fractions of 2^32.
inline glm::uvec2 sobol_2d(std::uint32_t index) {
    glm::uvec2 point(0);
    std::uint32_t mirrored = 0x80000000U, direction = 0x80000000U;
    for (; index != 0; index >>= 1, mirrored >>= 1, direction ^= direction >> 1)
        if ((index & 1U) != 0) point ^= glm::uvec2(mirrored, direction);
    return point;
}

}  // namespace pencil
