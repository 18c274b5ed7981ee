#include "surface/contacts.h"

#include <algorithm>

#include "pencils/low_discrepancy.h"

namespace pencil {

Contacts choose_contacts(const std::vector<unsigned char>& contact, const std::vector<SurfacePencil>& pencils, int texels,
                         const TexelPoints& points) {
    Contacts found;
    const std::uint64_t seed = hash64((std::uint64_t{points.seed} << 32) + points.turn);
    const auto blocks = static_cast<std::size_t>(texels / contact_block);
    for (std::size_t block = 0; block < blocks * pencils.size(); ++block) {
        const auto begin = contact.begin() + static_cast<std::ptrdiff_t>(block * contact_block);
        const auto count = static_cast<std::uint64_t>(std::count(begin, begin + contact_block, 1));
        if (count == 0) continue;
        const SurfacePencil& viewer = pencils[block / blocks];
        const std::uint64_t bits = hash64(seed ^ hash64(std::uint64_t{viewer.key} * blocks + block % blocks));
        std::uint64_t before = (bits >> 32) * count >> 32;  // of the block's contacts
        auto texel = begin;
        while (*texel == 0 || before-- > 0) ++texel;
        found.chosen.add(static_cast<int>(texel - contact.begin()), static_cast<uint>(bits), glm::vec3(viewer.position));
        found.counts.push_back(static_cast<float>(count));
    }
    return found;
}

}  // namespace pencil
