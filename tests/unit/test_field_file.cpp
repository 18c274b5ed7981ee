// Files of fields: what is written is read, and what is no field is refused.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <limits>

#include "field/field_file.h"
#include "image/write_image.h"
#include "util/error.h"

namespace pencil {
namespace {

const std::filesystem::path& field_path() {
    static const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("pencil-field-" + std::to_string(getpid()) + ".exr");
    return path;
}

PencilField small_field(int pencils = 3) {
    PencilField field;
    field.map = 8;
    field.free_share = 0.75;
    for (int i = 0; i < pencils; ++i) field.centres.emplace_back(i + 1.0 / 3.0, -2.5e-7 * i, 1e9);
    field.light.resize(3 * static_cast<std::size_t>(field.width()) * static_cast<std::size_t>(field.height()));
    for (std::size_t i = 0; i < field.light.size(); ++i) field.light[i] = 0.25F * static_cast<float>(i);
    return field;
}

TEST(FieldFile, HoldsWhatWasWritten) {
    for (const int pencils : {1, 2, 3, 5}) {
        const PencilField field = small_field(pencils);
        write_field(field_path(), field, "test");
        const PencilField read = read_field(field_path());
        EXPECT_EQ(read.map, field.map);
        EXPECT_EQ(read.free_share, field.free_share);
        EXPECT_EQ(read.centres, field.centres) << "to the last bit";
        EXPECT_EQ(read.light, field.light);
    }
    std::filesystem::remove(field_path());
}

TEST(FieldFile, TellsHowOftenItsLightIsReflected) {
    PencilField field = small_field();
    for (const int orders : {endless_orders, 1, 7}) {
        field.orders = orders;
        write_field(field_path(), field, "test");
        EXPECT_EQ(read_field(field_path()).orders, orders);
    }
    std::filesystem::remove(field_path());
}

TEST(FieldFile, WhatCouldNotBeReadAgainIsRefused) {
    EXPECT_EQ(field_bytes(3, 8), 3U * 4 * 16 * 16);
    EXPECT_NO_THROW(check_field_size(1 << 16, 64));
    EXPECT_THROW(check_field_size(1 << 16, 128), UsageError);
}

TEST(FieldFile, TilesStandInRows) {
    const PencilField field = small_field(3);
    EXPECT_EQ(field.columns(), 2);
    EXPECT_EQ(field.rows(), 2);
    EXPECT_EQ(field.index(0, 7, 7), 3U * (7 * 16 + 7));
    EXPECT_EQ(field.index(2, 1, 0), 3U * (8 * 16 + 1));
    EXPECT_EQ(field.tile_of(9, 0), 1);
    EXPECT_EQ(field.tile_of(0, 8), 2);
    EXPECT_EQ(field.tile_of(9, 8), field.count()) << "of no pencil";
}

/// Writes an image with this header and expects the words in the refusal.
void expect_refused(const Metadata& header, const std::vector<float>& light, int width, int height, const std::string& words) {
    write_image(field_path(), {width, height, {{"", 3, light.data()}}}, header);
    try {
        read_field(field_path());
        FAIL() << "was read: " << words;
    } catch (const SceneError& error) {
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find(field_path().string()), std::string::npos) << error.what();
    }
    std::filesystem::remove(field_path());
}

TEST(FieldFile, WhatIsNoFieldIsRefused) {
    const Metadata good{{"pencil:map", 8}, {"pencil:freeShare", 1.0}, {"pencil:centres", std::string("0 0 0")}};
    const std::vector<float> light(3 * 64, 1.0F);
    const auto with = [&](const std::string& key, const std::variant<int, double, std::string>& value) {
        Metadata header = good;
        header[key] = value;
        return header;
    };
    expect_refused({}, light, 8, 8, "pencil:map");
    expect_refused(with("pencil:map", 12), light, 8, 8, "multiple of 8");
    expect_refused(with("pencil:map", 2048), light, 8, 8, "8 to 1024");
    expect_refused(with("pencil:freeShare", -1.0), light, 8, 8, "freeShare");
    expect_refused(with("pencil:centres", std::string("")), light, 8, 8, "centres");
    expect_refused(with("pencil:centres", std::string("0 0")), light, 8, 8, "centres");
    expect_refused(with("pencil:centres", std::string("0 0 zero")), light, 8, 8, "centres");
    expect_refused(with("pencil:centres", std::string("0 0 1e300")), light, 8, 8, "centre 0");
    expect_refused(with("pencil:centres", std::string("0 0 0 1 1 1")), light, 8, 8, "16x8");
    for (const float bad : {-1.0F, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        std::vector<float> spoilt = light;
        spoilt[100] = bad;
        expect_refused(good, spoilt, 8, 8, "pixel 33");
    }
}

TEST(FieldFile, AFileThatIsMissingIsNamed) { EXPECT_THROW(read_field("/no/such/field.exr"), SceneError); }

}  // namespace
}  // namespace pencil
