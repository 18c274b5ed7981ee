// Sizes of the maps of every kind: about as many texels as the octahedral one, in squares that packets and blocks of rays divide.
#include <gtest/gtest.h>

#include "device/map_shape.h"

namespace {

using namespace pencil;

TEST(MapShape, OctahedralMapsAreAsWideAsAsked) {
    for (const int width : {0, 8, 24, 64, 1024}) {
        EXPECT_EQ(MapShape(width).n, width);
        EXPECT_EQ(MapShape(PENCIL_MAP_OCTAHEDRAL, width).texels(), width * width);
    }
}

TEST(MapShape, OtherKindsHaveAboutAsManyTexels) {
    for (const int kind : {PENCIL_MAP_PYRAMID, PENCIL_MAP_CUBE, PENCIL_MAP_PARABOLOID})
        for (int width = 8; width <= 1024; width += 8) {
            const MapShape shape(kind, width);
            EXPECT_EQ(shape.n % 4, 0);
            EXPECT_GE(shape.n, 4);
            EXPECT_EQ(shape.width, width);
            // A panel's side is rounded by at most 2 texels.
            const double side = shape.n * std::sqrt(shape.panels());
            EXPECT_LE(std::abs(side - width), 2.0 * std::sqrt(shape.panels()) + 1e-9) << "kind " << kind << " width " << width;
        }
    EXPECT_EQ(MapShape(PENCIL_MAP_CUBE, 64).n, 28);
    EXPECT_EQ(MapShape(PENCIL_MAP_PYRAMID, 64).n, 44);
    EXPECT_EQ(MapShape(PENCIL_MAP_PARABOLOID, 64).n, 44);
}

TEST(MapShape, NoMapsAreNone) {
    for (int kind = 0; kind < 4; ++kind) EXPECT_EQ(MapShape(kind, 0).texels(), 0);
}

}  // namespace
