// Device memory: contents survive the way there and back, ranges are checked, and the plan is balanced at the end.
#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <stdexcept>

#include "cl/buffer.h"
#include "util/error.h"

namespace pencil {
namespace {

struct DeviceBuffer : testing::Test {
    std::shared_ptr<Device> device = Device::open("");
    ~DeviceBuffer() override { EXPECT_EQ(device->allocated(), 0u) << "not everything was given back"; }
};

std::vector<int> numbers(int count) {
    std::vector<int> values(count);
    std::iota(values.begin(), values.end(), 1);
    return values;
}

TEST_F(DeviceBuffer, RoundTripWholeAndInParts) {
    for (const int count : {1, 7, 1000, 1 << 18}) {
        Buffer<int> buffer(device, numbers(count), "numbers");
        EXPECT_EQ(buffer.size(), static_cast<std::size_t>(count));
        EXPECT_EQ(buffer.read(), numbers(count));
        EXPECT_EQ(buffer.read(count - 1, 1), std::vector<int>{count});
        buffer.write({-1}, count - 1);
        EXPECT_EQ(buffer.read().back(), -1);
        EXPECT_EQ(buffer.read(0, 1), std::vector<int>{count == 1 ? -1 : 1});
    }
}

TEST_F(DeviceBuffer, RowsComeInOneTransfer) {
    Buffer<int> buffer(device, numbers(20), "numbers");
    EXPECT_EQ(buffer.read_rows(0, 5, 4, 5), numbers(20));
    EXPECT_EQ(buffer.read_rows(1, 5, 3, 2), (std::vector<int>{2, 3, 7, 8, 12, 13}));
    EXPECT_EQ(buffer.read_rows(8, 5, 3, 2), (std::vector<int>{9, 10, 14, 15, 19, 20})) << "from the second row on";
    EXPECT_EQ(buffer.read_rows(19, 20, 1, 1), std::vector<int>{20});
    EXPECT_TRUE(buffer.read_rows(0, 5, 4, 0).empty());
    EXPECT_THROW(buffer.read_rows(9, 5, 3, 2), std::out_of_range);
    EXPECT_THROW(buffer.read_rows(0, 5, 2, 6), std::out_of_range) << "rows overlap";
}

TEST_F(DeviceBuffer, EmptyIsAllowed) {
    Buffer<float> buffer(device, std::vector<float>{}, "no lights");
    EXPECT_TRUE(buffer.empty());
    EXPECT_TRUE(buffer.read().empty());
    buffer.write({});
    buffer.fill_zero();
    EXPECT_NE(buffer.handle()(), nullptr) << "kernels take it as an argument";
}

TEST_F(DeviceBuffer, FillZeroClearsOddSizes) {
    for (const int count : {1, 3, 4, 1023}) {
        Buffer<unsigned char> buffer(device, std::vector<unsigned char>(count, 255), "bytes");
        buffer.fill_zero();
        EXPECT_EQ(buffer.read(), std::vector<unsigned char>(count, 0)) << count;
    }
}

TEST_F(DeviceBuffer, RangesAreChecked) {
    Buffer<int> buffer(device, numbers(10), "ten numbers");
    EXPECT_THROW(buffer.read(0, 11), std::out_of_range);
    EXPECT_THROW(buffer.read(11, 1), std::out_of_range);
    EXPECT_THROW(buffer.write(numbers(4), 7), std::out_of_range);
    EXPECT_THROW(Buffer<int>(device, 0, "none").write(numbers(1)), std::out_of_range);
    EXPECT_EQ(buffer.read(), numbers(10));
}

TEST_F(DeviceBuffer, PlanFollowsMovesAndDestruction) {
    {
        Buffer<int> a(device, 256, "a");
        EXPECT_EQ(device->allocated(), 1024u);
        Buffer<int> b = std::move(a);
        EXPECT_EQ(device->allocated(), 1024u);
        Buffer<int> c(device, 512, "c");
        EXPECT_EQ(device->allocated(), 3072u);
        c = std::move(b);
        EXPECT_EQ(device->allocated(), 1024u) << "what was overwritten is given back";
    }
    EXPECT_EQ(device->allocated(), 0u);
    EXPECT_EQ(device->peak_allocated(), 3072u);

    BufferStorage first(device, 100, "first"), second(device, 50, "second");
    BufferStorage third(std::move(first));
    third = std::move(second);
    EXPECT_EQ(third.what(), "second");
}

TEST_F(DeviceBuffer, WithoutStorageThrows) {
    Buffer<int> none;
    EXPECT_TRUE(none.empty());
    EXPECT_TRUE(none.read().empty());
    EXPECT_THROW(none.handle(), std::logic_error);
    EXPECT_THROW(none.write(numbers(1)), std::logic_error);
}

TEST_F(DeviceBuffer, TooLargeIsAMemoryErrorThatNamesTheContents) {
    for (const std::uint64_t bytes : {device->info().max_allocation + 4, std::numeric_limits<std::uint64_t>::max()}) {
        try {
            Buffer<int> buffer(device, bytes / 4, "radiance of a million pencils");
            FAIL() << "allocated " << bytes << " bytes";
        } catch (const MemoryError& error) {
            EXPECT_NE(std::string(error.what()).find("radiance of a million pencils"), std::string::npos) << error.what();
        }
    }
    EXPECT_THROW(Buffer<double>(device, std::numeric_limits<std::size_t>::max() / 4, "overflow"), MemoryError);
}

}  // namespace
}  // namespace pencil
