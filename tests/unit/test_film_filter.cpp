// Reconstruction filters and their tables against the double-precision definitions.
#include <gtest/gtest.h>

#include "pencils/film_filter.h"
#include "reference/film_ref.h"
#include "scene/filter_value.h"

namespace {

using namespace pencil;
using Kind = ReconstructionFilter::Kind;

ReconstructionFilter filter(Kind kind, double radius) {
    ReconstructionFilter f;
    f.kind = kind;
    f.radius = radius;
    return f;
}

TEST(FilmFilter, ValuesOfEveryKind) {
    for (int i = -300; i <= 300; ++i) {
        const double x = i * 0.0107;  // off the ends of the supports
        EXPECT_NEAR(filter_value(filter(Kind::box, 0.5), x), ref::box_filter(x), 1e-12) << "box at " << x;
        EXPECT_NEAR(filter_value(filter(Kind::tent, 1.0), x), ref::tent_filter(x), 1e-12) << "tent at " << x;
        EXPECT_NEAR(filter_value(filter(Kind::gaussian, 2.0), x), ref::gaussian_filter(x), 1e-12) << "gaussian at " << x;
        EXPECT_NEAR(filter_value(filter(Kind::mitchell, 2.0), x), ref::mitchell_filter(x), 1e-12) << "mitchell at " << x;
        EXPECT_NEAR(filter_value(filter(Kind::catmullrom, 2.0), x), ref::catmullrom_filter(x), 1e-12) << "catmullrom at " << x;
        EXPECT_NEAR(filter_value(filter(Kind::lanczos, 3.0), x), ref::lanczos_filter(x), 1e-12) << "lanczos at " << x;
    }
}

TEST(FilmFilter, OffsetsFillThePixel) {
    for (const int samples : {1, 2, 5, 16, 64}) {
        const std::vector<glm::vec2> offsets = film_sample_offsets(samples, 3);
        ASSERT_EQ(offsets.size(), static_cast<std::size_t>(samples));
        glm::dvec2 mean(0.0);
        for (const glm::vec2& o : offsets) {
            EXPECT_TRUE(o.x >= 0.0F && o.x < 1.0F && o.y >= 0.0F && o.y < 1.0F) << o.x << " " << o.y;
            mean += glm::dvec2(o) / static_cast<double>(samples);
        }
        EXPECT_LT(glm::distance(mean, glm::dvec2(0.5)), samples >= 16 ? 0.1 : 0.71) << samples << " samples";
    }
}

TEST(FilmFilter, TablesHoldTheFilterAtEverySample) {
    const std::vector<glm::vec2> offsets = film_sample_offsets(5, 4);
    for (const auto& [kind, radius] : {std::pair{Kind::box, 0.5}, std::pair{Kind::gaussian, 2.0}, std::pair{Kind::lanczos, 3.0}}) {
        const FilterTable table = tabulate_filter(filter(kind, radius), offsets);
        const int side = 2 * table.reach + 1;
        ASSERT_GE(table.reach + 0.5, radius) << "a sample a radius away from the pixel's centre must be reached";
        ASSERT_EQ(table.weights.size(), static_cast<std::size_t>(side * side) * offsets.size());
        ASSERT_EQ(table.totals.size(), static_cast<std::size_t>(side * side));
        for (int cell = 0; cell < side * side; ++cell) {
            double total = 0.0;
            const int column = cell % side, row = cell / side;
            for (std::size_t s = 0; s < offsets.size(); ++s) {
                const double dx = column - table.reach + static_cast<double>(offsets[s].x) - 0.5,
                             dy = row - table.reach + static_cast<double>(offsets[s].y) - 0.5;
                const double expected = filter_value(filter(kind, radius), dx) * filter_value(filter(kind, radius), dy);
                const float got = table.weights[static_cast<std::size_t>(cell) * offsets.size() + s];
                ASSERT_NEAR(got, expected, 1e-6) << "cell " << cell << " sample " << s << " at " << dx << " " << dy;
                total += expected;
            }
            ASSERT_NEAR(table.totals[static_cast<std::size_t>(cell)], total, 1e-5) << "cell " << cell;
        }
    }
}

}  // namespace
