// Quantities as texts.
#include <gtest/gtest.h>

#include <cmath>

#include "util/format.h"

namespace pencil {
namespace {

TEST(Format, Sizes) {
    EXPECT_EQ(format_size(0), "0 bytes");
    EXPECT_EQ(format_size(1023), "1023 bytes");
    EXPECT_EQ(format_size(1024), "1.0 KiB");
    EXPECT_EQ(format_size(std::uint64_t{25} << 19), "12.5 MiB");
    EXPECT_EQ(format_size(std::uint64_t{5} << 50), "5120.0 TiB");
}

TEST(Format, Numbers) {
    EXPECT_EQ(format_short(0), "0");
    EXPECT_EQ(format_short(0.0012345), "0.00123");
    EXPECT_EQ(format_short(1234567), "1.23e+06");
    EXPECT_EQ(format_short(INFINITY), "inf");
    EXPECT_EQ(format_fixed(1.00004, 4), "1.0000");
    EXPECT_EQ(format_fixed(-20, 2), "-20.00");
    EXPECT_EQ(format_fixed(2.5e12, 2), "2.50e+12");
    EXPECT_EQ(format_extent(320, 240), "320x240");
}

}  // namespace
}  // namespace pencil
