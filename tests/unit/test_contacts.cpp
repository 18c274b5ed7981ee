// Which of the contacts of a block gathers for the others.
#include <gtest/gtest.h>

#include "surface/contacts.h"

namespace {

using namespace pencil;

constexpr int texels = 64;

std::vector<SurfacePencil> viewers(int count) {
    std::vector<SurfacePencil> pencils(static_cast<std::size_t>(count));
    for (int p = 0; p < count; ++p) {
        pencils[static_cast<std::size_t>(p)].position = float4(p, 2 * p, 0, 0);
        pencils[static_cast<std::size_t>(p)].key = static_cast<uint>(7 * p);
    }
    return pencils;
}

TEST(Contacts, NoneWhereNothingIsNear) {
    EXPECT_TRUE(choose_contacts(std::vector<unsigned char>(5 * texels, 0), viewers(5), texels, {}).counts.empty());
    EXPECT_TRUE(choose_contacts({}, {}, texels, {}).counts.empty());
}

TEST(Contacts, OneOfEachBlockStandsForAllOfIt) {
    std::vector<unsigned char> contact(3 * texels, 0);
    for (const int i : {5, texels + 16, texels + 17, texels + 31, 3 * texels - 1}) contact[static_cast<std::size_t>(i)] = 1;
    const std::vector<SurfacePencil> seeing = viewers(3);
    const Contacts found = choose_contacts(contact, seeing, texels, {3, 1});
    ASSERT_EQ(found.counts, (std::vector<float>{1, 3, 1}));
    EXPECT_EQ(found.chosen.surfels.front(), 5);
    EXPECT_EQ(found.chosen.surfels.back(), 3 * texels - 1);
    const int middle = found.chosen.surfels[1];
    EXPECT_TRUE(middle == texels + 16 || middle == texels + 17 || middle == texels + 31) << middle;
    EXPECT_EQ(glm::vec3(found.chosen.views[1]), glm::vec3(seeing[1].position)) << "seen from its viewer";
}

/// Over many turns each contact is chosen equally often: within five standard deviations.
TEST(Contacts, EachIsAsLikely) {
    std::vector<unsigned char> contact(contact_block, 0);
    for (const std::size_t i : {0, 3, 9, 15}) contact[i] = 1;
    constexpr int turns = 4000;
    std::vector<int> chosen(contact_block, 0);
    for (uint turn = 0; turn < turns; ++turn) {
        const Contacts found = choose_contacts(contact, viewers(1), contact_block, {42, turn});
        ASSERT_EQ(found.chosen.surfels.size(), 1U);
        ++chosen[static_cast<std::size_t>(found.chosen.surfels[0])];
    }
    for (std::size_t i = 0; i < contact.size(); ++i)
        EXPECT_NEAR(chosen[i], contact[i] * turns / 4, contact[i] * 5 * std::sqrt(turns * 3 / 16.0)) << i;
}

}  // namespace
