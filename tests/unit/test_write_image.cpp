// Image files: what is written comes back, bytes repeat, and damaged or hostile files are refused before memory is taken.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <numeric>

#include "image/read_image.h"
#include "image/write_image.h"
#include "util/error.h"
#include "util/output_file.h"
#include "util/progress.h"

namespace pencil {
namespace {

namespace fs = std::filesystem;

class ImageFiles : public testing::Test {
protected:
    ImageFiles() {
        std::string name = (fs::temp_directory_path() / "pencil-image-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
        std::iota(beauty_.begin(), beauty_.end(), -3.0F);
        std::iota(depth_.begin(), depth_.end(), 100.0F);
        image_ = {width, height, {{"", 3, beauty_.data()}, {"normal", 3, beauty_.data()}, {"depth", 1, depth_.data()}}};
    }
    ~ImageFiles() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    fs::path file(const std::string& name) const { return folder_ / name; }
    static std::string bytes_of(const fs::path& path) {
        std::ifstream stream(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    void put(const fs::path& path, const std::string& bytes) const { std::ofstream(path, std::ios::binary) << bytes; }

    static constexpr int width = 5, height = 131;  // more than one block of rows, and not a multiple of it
    fs::path folder_;
    std::vector<float> beauty_ = std::vector<float>(std::size_t(width) * height * 3);
    std::vector<float> depth_ = std::vector<float>(std::size_t(width) * height);
    LayeredImage image_;
};

TEST_F(ImageFiles, ExrKeepsEveryFloatAndNamesTheChannels) {
    beauty_[7] = 1e30F;
    beauty_[8] = 1e-40F;
    EXPECT_TRUE(write_image(file("a.exr"), image_).empty());
    const Image read = read_image(file("a.exr"));
    EXPECT_EQ(read.width, width);
    EXPECT_EQ(read.height, height);
    EXPECT_EQ(read.channels, (std::vector<std::string>{"R", "G", "B", "depth.Z", "normal.X", "normal.Y", "normal.Z"}));
    for (int pixel = 0; pixel < width * height; ++pixel) {
        for (int c = 0; c < 3; ++c) {
            ASSERT_EQ(read.pixels[pixel * 7 + c], beauty_[pixel * 3 + c]) << pixel;
            ASSERT_EQ(read.pixels[pixel * 7 + 4 + c], beauty_[pixel * 3 + c]) << pixel;
        }
        ASSERT_EQ(read.pixels[pixel * 7 + 3], depth_[pixel]) << pixel;
    }
}

TEST_F(ImageFiles, BytesDependOnNothingButTheImage) {
    const Metadata metadata{{"pencil:decay", 0.7}, {"pencil:pencils", 128}, {"pencil:scene", std::string("room.xml")}};
    write_image(file("a.exr"), image_, metadata);
    write_image(file("a.png"), image_, metadata);
    fs::create_directory(file("deep"));
    write_image(file("deep/other.exr"), image_, metadata);
    write_image(file("deep/other.png"), image_, metadata);
    EXPECT_EQ(bytes_of(file("a.exr")), bytes_of(file("deep/other.exr")));
    EXPECT_EQ(bytes_of(file("a.png")), bytes_of(file("deep/other.png")));
}

/// Files of one second would agree on it: the time of day must not be there at all. OpenImageIO writes an empty capDate if told so.
TEST_F(ImageFiles, NoTimeOfDayIsWritten) {
    write_image(file("a.exr"), image_);
    write_image(file("a.png"), image_);
    const auto exr = OIIO::ImageInput::open(file("a.exr").string());
    ASSERT_NE(exr, nullptr);
    EXPECT_EQ(exr->spec().get_string_attribute("DateTime"), "");
    const std::string png = bytes_of(file("a.png"));
    for (const char* key : {"tIME", "DateTime", "date:create", "date:modify", "Creation Time"})
        EXPECT_EQ(png.find(key), std::string::npos) << key;
}

TEST_F(ImageFiles, PngShowsSrgb) {
    const std::vector<float> linear{-1, 0, 0.0031308F, 0.18F, 0.5F, 1, 7, 0.2140411F, 0};
    write_image(file("a.png"), {3, 1, {{"", 3, linear.data()}}});
    const Image read = read_image(file("a.png"));
    const std::vector<int> expected{0, 0, 10, 118, 188, 255, 255, 127, 0};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(read.pixels[i] * 255, expected[i], i == 7 ? 1.01 : 0.01) << i;  // 0.21404 lies on the border of 127 and 128
    }
}

TEST_F(ImageFiles, NonFiniteValuesAreCountedAndPlaced) {
    beauty_[3 * (2 * width + 4) + 1] = std::numeric_limits<float>::quiet_NaN();
    beauty_[3 * (9 * width + 1)] = -std::numeric_limits<float>::infinity();
    const std::vector<std::string> exr = write_image(file("a.exr"), image_);
    ASSERT_EQ(exr.size(), 1U);
    EXPECT_EQ(exr[0], "a.exr: 4 values are NaN or infinite, the first in channel G at pixel (4, 2)");  // normal has the same pixels
    EXPECT_TRUE(std::isnan(read_image(file("a.exr")).pixels[7 * (2 * width + 4) + 1]));
    const std::vector<std::string> png = write_image(file("a.png"), image_);
    ASSERT_EQ(png.size(), 1U);
    EXPECT_EQ(png[0], "a.png: 2 values are NaN or infinite and written as 0, the first in channel G at pixel (4, 2)");
    EXPECT_EQ(read_image(file("a.png")).pixels[3 * (2 * width + 4) + 1], 0);
}

TEST_F(ImageFiles, OtherExtensionsAreAUsageError) {
    EXPECT_THROW(write_image(file("a.jpg"), image_), UsageError);
    EXPECT_THROW(write_image(file("a"), image_), UsageError);
    EXPECT_EQ(image_format("b.EXR"), ImageFormat::exr);
}

TEST_F(ImageFiles, FailedWritesKeepTheOldFileAndLeaveNothing) {
    put(file("a.bin"), "older");
    const std::string large(1 << 20, 'x');
    struct rlimit before {};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const struct rlimit small { 4096, before.rlim_max };
    auto* const handler = ::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &small);
    EXPECT_THROW(write_file(file("a.bin"), large.data(), large.size()), OutputError);
    ::setrlimit(RLIMIT_FSIZE, &before);
    ::signal(SIGXFSZ, handler);
    EXPECT_EQ(bytes_of(file("a.bin")), "older");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(ImageFiles, EveryTruncationIsRefused) {
    for (const char* name : {"a.exr", "a.png"}) {
        write_image(file(name), image_);
        const std::string whole = bytes_of(file(name));
        for (std::size_t length = 0; length + 16 < whole.size(); length += 1 + whole.size() / 60) {
            put(file("cut"), whole.substr(0, length));
            EXPECT_THROW(read_image(file("cut")), SceneError) << name << " cut after " << length << " of " << whole.size();
        }
    }
}

void expect_too_large(const fs::path& path, std::uint64_t most_bytes = largest_image) {
    try {
        read_image(path, most_bytes);
        ADD_FAILURE() << path << " was accepted";
    } catch (const SceneError& error) {
        EXPECT_NE(std::string(error.what()).find("is too large"), std::string::npos) << error.what();
    }
}

TEST_F(ImageFiles, SizesAreJudgedBeforeMemoryIsTaken) {
    put(file("huge.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2000000000 +X 2000000000\n");
    expect_too_large(file("huge.hdr"));
    // The header of 100000 x 100000 pixels, with a valid checksum.
    const std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\1\x86\xa0\0\1\x86\xa0\x08\2\0\0\0", 29);
    put(file("huge.png"), png + std::string("\x27\x30\x9c\x9f\0\0\0\1IDATx", 13));
    expect_too_large(file("huge.png"));
    write_image(file("a.exr"), image_);
    expect_too_large(file("a.exr"), 1000);
}

TEST_F(ImageFiles, FormatsAreToldByContent) {
    write_image(file("a.png"), image_);
    fs::rename(file("a.png"), file("a.exr"));
    EXPECT_EQ(read_image(file("a.exr")).width, width);
    put(file("b.png"), "P6 5 5 255\n" + std::string(75, 'x'));
    EXPECT_THROW(read_image(file("b.png")), SceneError);
    EXPECT_THROW(read_image(file("none.png")), SceneError);
    EXPECT_THROW(read_image(folder_), SceneError);
}

TEST(Progress, DurationsAreReadable) {
    EXPECT_EQ(format_duration(7.4), "0:07");
    EXPECT_EQ(format_duration(760), "12:40");
    EXPECT_EQ(format_duration(11100), "3:05:00");
    EXPECT_EQ(format_duration(-1), "0:00");
    EXPECT_EQ(format_duration(1e30), "99:59:59");
}

TEST(Progress, LinesAppearAtTheFirstTimeOfAStage) {
    char* text = nullptr;
    std::size_t size = 0;
    std::FILE* stream = ::open_memstream(&text, &size);
    {
        ProgressDisplay display(ProgressDisplay::Style::lines, stream);
        display.update("gather", 0);
        display.update("gather", 0.5);
        display.update("film", 0.7);
        display.update("gather", 0.8);
    }
    std::fclose(stream);
    EXPECT_EQ(std::string(text, size), "pencil: gather\npencil: film\n");
    std::free(text);
}

}  // namespace
}  // namespace pencil
