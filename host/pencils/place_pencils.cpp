#include "pencils/place_pencils.h"

#include "pencils/low_discrepancy.h"

namespace pencil {

std::vector<float4> place_pencils(const FlatScene& flat, Sequence sequence, int first, int count, int set, std::uint64_t seed) {
    const auto stream = static_cast<std::uint64_t>(set);
    auto random = [&](std::uint64_t index) { return random_unit(seed, stream, index); };
    const glm::dvec3 shift(random(0), random(1), random(2));
    std::vector<float4> cops;
    cops.reserve(static_cast<std::size_t>(count));
    for (int k = first; k < first + count; ++k) {
        const auto i = static_cast<std::uint64_t>(k) + 1;
        const glm::dvec3 u =
            sequence == Sequence::low_discrepancy ? r3_sequence(i, shift) : glm::dvec3(random(3 * i), random(3 * i + 1), random(3 * i + 2));
        cops.emplace_back(glm::vec3(flat.low + u * (flat.high - flat.low)), 0.0F);
    }
    return cops;
}

}  // namespace pencil
