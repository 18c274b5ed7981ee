// Parts of fields: single pencils of files, and which of them a view takes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <limits>

#include "field/field_file.h"
#include "image/write_image.h"
#include "line/field_subset.h"
#include "util/error.h"

namespace pencil {
namespace {

std::filesystem::path part_path() { return std::filesystem::temp_directory_path() / ("pencil-part-" + std::to_string(getpid()) + ".exr"); }

PencilField numbered_field(int pencils, int map) {
    PencilField field;
    field.map = map;
    for (int i = 0; i < pencils; ++i) field.centres.emplace_back(i, 0.5, -i);
    field.light.resize(3 * static_cast<std::size_t>(field.width()) * static_cast<std::size_t>(field.height()));
    for (std::size_t i = 0; i < field.light.size(); ++i) field.light[i] = 0.25F * static_cast<float>(i % 100003);
    return field;
}

void expect_parts(const PencilField& field, const std::string& what) {
    FieldFile file(part_path());
    EXPECT_EQ(file.head().centres, field.centres);
    EXPECT_TRUE(file.head().light.empty());
    for (int pencil = field.count() - 1; pencil >= 0; --pencil) {
        const std::vector<float> light = file.light(pencil);
        ASSERT_EQ(light.size(), 3U * static_cast<std::size_t>(field.map * field.map)) << what;
        for (int y = 0; y < field.map; ++y)
            for (int x = 0; x < field.map; ++x)
                for (std::size_t c = 0; c < 3; ++c)
                    ASSERT_EQ(light[3 * static_cast<std::size_t>(y * field.map + x) + c], field.light[field.index(pencil, x, y) + c])
                        << what << ", pencil " << pencil << ", texel " << x << ", " << y;
    }
    std::filesystem::remove(part_path());
}

TEST(FieldFileParts, IsThatOfTheWholeFile) {
    for (const int pencils : {1, 3, 5})
        for (const int map : {8, 24}) {
            const PencilField field = numbered_field(pencils, map);
            write_field(part_path(), field, "test");
            expect_parts(field, "tiles");
        }
}

/// Files by other renderers may be stored as rows, or in tiles of another size.
TEST(FieldFileParts, IsReadFromRowsAndOtherTilesToo) {
    const PencilField field = numbered_field(5, 24);
    const Metadata header{
        {"pencil:map", 24}, {"pencil:freeShare", 1.0}, {"pencil:centres", std::string("0 .5 0 1 .5 -1 2 .5 -2 3 .5 -3 4 .5 -4")}};
    for (const int tile : {0, 16, 40}) {
        write_image(part_path(), {field.width(), field.height(), {{"", 3, field.light.data()}}, tile}, header);
        EXPECT_EQ(read_field(part_path()).light, field.light) << tile;
        expect_parts(field, "tiles of " + std::to_string(tile));
    }
}

TEST(FieldFileParts, ThatIsNoLightIsRefused) {
    PencilField field = numbered_field(3, 8);
    field.light[field.index(1, 3, 2)] = std::numeric_limits<float>::infinity();
    write_field(part_path(), field, "test");
    FieldFile file(part_path());
    EXPECT_NO_THROW(file.light(0));
    EXPECT_THROW(file.light(1), SceneError);
    std::filesystem::remove(part_path());
    EXPECT_THROW(FieldFile("/no/such/field.exr"), SceneError);
}

std::vector<int> sorted(std::vector<int> numbers) {
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

TEST(SubsetSlots, TakeWhatIsSeenFirstAndThenTheOthers) {
    SubsetSlots slots(3);
    EXPECT_EQ(slots.choose({0, 5, 0, 1, 7, 2}).size(), 3U);
    EXPECT_EQ(slots.pencils(), (std::vector<int>{1, 3, 4}));
    SubsetSlots more(4);
    more.choose({0, 0, 9, 0, 1});
    EXPECT_EQ(sorted(more.pencils()), (std::vector<int>{0, 1, 2, 4}));
}

TEST(SubsetSlots, ThoseThatAreStillWantedStayWhereTheyAre) {
    SubsetSlots slots(3);
    slots.choose({1, 1, 1, 1, 1, 1});
    EXPECT_TRUE(slots.choose({2, 2, 2, 0, 0, 0}).empty());
    EXPECT_EQ(slots.choose({1, 0, 1, 0, 1, 1}), (std::vector<int>{1}));
    EXPECT_EQ(slots.pencils(), (std::vector<int>{0, 4, 2}));
}

TEST(SubsetSlots, AreThinnerWhereMoreIsSeen) {
    EXPECT_EQ(subset_density({1, 1, 1, 1}, 2), 0.5);
    EXPECT_EQ(subset_density({1, 0, 0, 1}, 2), 1.0);
    EXPECT_EQ(subset_density({1, 0, 0, 0}, 2), 1.0);
    EXPECT_EQ(subset_density({0, 0}, 2), 1.0);
}

}  // namespace
}  // namespace pencil
