// The cost model of geometry maps: sane in every direction, and a plan is never slower than what it leaves out.
#include <gtest/gtest.h>

#include "visibility/visibility_path.h"

namespace pencil {
namespace {

constexpr int units = 2;
const int triangle_counts[] = {1, 38, 1000, 15710, 100365, 5000000};
const int map_sizes[] = {8, 16, 64, 256};

double plan_seconds(int triangles, const std::vector<MapBatch>& batches, const Prepared& prepared) {
    double sum = prepared.clusters ? preparation_seconds(VisibilityPath::clusters, triangles) : 0;
    sum += prepared.bvh ? preparation_seconds(VisibilityPath::trace, triangles) : 0;
    for (const MapBatch& b : batches) sum += maps_seconds(choose_path(triangles, b, units, prepared), triangles, b, units);
    return sum;
}

TEST(VisibilityPath, MoreWorkTakesLonger) {
    for (const VisibilityPath path : visibility_paths)
        for (const int triangles : triangle_counts)
            for (const int size : map_sizes) {
                const double seconds = maps_seconds(path, triangles, {100, size}, units);
                EXPECT_GT(seconds, 0.0);
                EXPECT_GT(maps_seconds(path, 2 * triangles, {100, size}, units), seconds);
                EXPECT_GT(maps_seconds(path, triangles, {100, 2 * size}, units), seconds);
                EXPECT_DOUBLE_EQ(maps_seconds(path, triangles, {200, size}, units), 2 * seconds);
                EXPECT_DOUBLE_EQ(maps_seconds(path, triangles, {100, size}, 2 * units), 0.5 * seconds);
                EXPECT_GE(preparation_seconds(path, 2 * triangles), preparation_seconds(path, triangles));
            }
}

TEST(VisibilityPath, NothingIsPreparedForNothing) {
    const Prepared none = plan_preparation(1000000, {}, units);
    EXPECT_FALSE(none.clusters || none.bvh);
}

TEST(VisibilityPath, ChoosesAmongWhatIsPrepared) {
    for (const int triangles : triangle_counts)
        for (const int size : map_sizes) {
            const MapBatch batch{100, size};
            EXPECT_EQ(choose_path(triangles, batch, units, {false, false}), VisibilityPath::rasterize);
            EXPECT_NE(choose_path(triangles, batch, units, {true, false}), VisibilityPath::trace);
            EXPECT_NE(choose_path(triangles, batch, units, {false, true}), VisibilityPath::clusters);
        }
    EXPECT_EQ(choose_path(100000, {100, 6}, units, {false, true}), VisibilityPath::rasterize) << "packets need blocks of 4 x 4 texels";
}

TEST(VisibilityPath, FewTrianglesAreRasterizedManyAreNot) {
    const Prepared few = plan_preparation(38, {{64, 256}, {400, 64}}, units);
    EXPECT_FALSE(few.clusters || few.bvh);
    const Prepared once = plan_preparation(100365, {{1, 8}}, units);
    EXPECT_FALSE(once.clusters || once.bvh) << "one small map does not pay for preparation";
    const Prepared many = plan_preparation(100365, {{64, 256}, {400, 64}}, units);
    EXPECT_TRUE(many.bvh);
}

TEST(VisibilityPath, PlanIsTheFastest) {
    for (const int triangles : triangle_counts)
        for (const int maps : {1, 10, 328, 5000})
            for (const int size : map_sizes) {
                const std::vector<MapBatch> batches{{maps, size}, {64, 256}};
                const double planned = plan_seconds(triangles, batches, plan_preparation(triangles, batches, units));
                for (const bool clusters : {false, true})
                    for (const bool bvh : {false, true}) EXPECT_LE(planned, plan_seconds(triangles, batches, {clusters, bvh}));
            }
}

TEST(VisibilityPath, ExplainsWhatWasChosen) {
    const std::vector<MapBatch> batches{{400, 64}};
    const std::string few = explain_paths(38, batches, units, {false, false});
    EXPECT_NE(few.find("400 octahedral maps of 64x64 texels rasterised (predicted: rasterised "), std::string::npos) << few;
    EXPECT_NE(few.find("nothing to prepare"), std::string::npos) << few;
    const std::string many = explain_paths(100365, batches, units, {false, true});
    EXPECT_NE(many.find("400 octahedral maps of 64x64 texels traced"), std::string::npos) << many;
    EXPECT_NE(many.find("hierarchy 0.07 s"), std::string::npos) << many;
}

TEST(VisibilityPath, OtherKindsAreDrawnByClustersOrTraced) {
    const std::vector<MapBatch> batches{{400, 64}};
    for (const int triangles : {38, 100365})
        for (const int kind : {PENCIL_MAP_PYRAMID, PENCIL_MAP_CUBE, PENCIL_MAP_PARABOLOID}) {
            const Prepared prepared = plan_preparation(triangles, batches, units, kind);
            const VisibilityPath path = choose_path(triangles, batches[0], units, prepared, kind);
            EXPECT_EQ(path, kind != PENCIL_MAP_PARABOLOID && triangles == 38 ? VisibilityPath::clusters : VisibilityPath::trace);
            EXPECT_EQ(prepared.bvh, path == VisibilityPath::trace);
        }
    EXPECT_THROW(choose_path(38, batches[0], units, {true, false}, PENCIL_MAP_PARABOLOID), std::logic_error);
    const std::string cubes = explain_paths(38, batches, units, {true, false}, PENCIL_MAP_CUBE);
    EXPECT_NE(cubes.find("400 cube maps of 6 x 28x28 texels rasterised by clusters (predicted: rasterised by clusters "), std::string::npos)
        << cubes;
}

}  // namespace
}  // namespace pencil
