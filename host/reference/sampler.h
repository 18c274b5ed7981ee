// Points for one path: Sobol' pairs, Owen-scrambled and shuffled by hashing (Burley 2020, "Practical Hash-based Owen Scrambling"). Each
// pair of dimensions is a (0,2)-sequence in base 2 over the sample index; different pairs, and different seeds, are independent.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace pencil {

/// Finaliser of MurmurHash3: a bijective hash of 64 bits.
inline std::uint64_t mix_bits(std::uint64_t x) {
    x = (x ^ (x >> 33)) * 0xff51afd7ed558ccdULL;
    x = (x ^ (x >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    return x ^ (x >> 33);
}

inline std::uint32_t reverse_bits(std::uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x & 0x00ff00ffU) << 8) | ((x >> 8) & 0x00ff00ffU);
    x = ((x & 0x0f0f0f0fU) << 4) | ((x >> 4) & 0x0f0f0f0fU);
    x = ((x & 0x33333333U) << 2) | ((x >> 2) & 0x33333333U);
    return ((x & 0x55555555U) << 1) | ((x >> 1) & 0x55555555U);
}

/// Owen's nested uniform scramble of a number whose bits are reversed: each bit is flipped depending on those below it (Laine and Karras
/// 2011, with Vegdahl's constants).
inline std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeaU;
    x += seed;
    x *= (seed >> 16) | 1U;
    x ^= x * 0x05526c56U;
    x ^= x * 0x53a22864U;
    return x;
}

/// The second Sobol' dimension with its bits reversed: Pascal's triangle modulo 2 as a product of shifts (Ahmed 2024).
inline std::uint32_t sobol_second_reversed(std::uint32_t index) {
    index ^= (index >> 16) & 0x0000ffffU;
    index ^= (index >> 8) & 0x00ff00ffU;
    index ^= (index >> 4) & 0x0f0f0f0fU;
    index ^= (index >> 2) & 0x33333333U;
    return index ^ ((index >> 1) & 0x55555555U);
}

class Sampler {
public:
    /// Sample `index` of the sequence that `seed` names.
    Sampler(std::uint64_t seed, std::uint32_t index) : seed_(seed), reversed_index_(reverse_bits(index)), index_(index) {}

    /// The next pair of dimensions, in [0, 1)^2.
    glm::dvec2 next_2d() {
        const std::uint64_t h = next_hash();
        const auto low = static_cast<std::uint32_t>(h), high = static_cast<std::uint32_t>(h >> 32);
        const std::uint32_t shuffled = reverse_bits(scramble_reversed(reversed_index_, low));
        return {unit(reverse_bits(scramble_reversed(shuffled, high))),
                unit(reverse_bits(scramble_reversed(sobol_second_reversed(shuffled), low * 0x9e3779b9U ^ high)))};
    }

    /// A pseudo-random number in [0, 1), for decisions that gain nothing from stratification.
    double next_1d() { return unit(static_cast<std::uint32_t>(mix_bits(next_hash() ^ index_))); }

private:
    std::uint64_t next_hash() { return mix_bits(seed_ += 0x9e3779b97f4a7c15ULL); }
    static double unit(std::uint32_t bits) { return bits * 0x1p-32; }

    std::uint64_t seed_;
    std::uint32_t reversed_index_, index_;
};

}  // namespace pencil
