// Values to bytes and back, and bytes that are no values.
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "util/archive.h"

namespace {

using namespace pencil;

struct Inner {
    std::string name;
    std::vector<float> values;
    void transfer(Archive& archive) { archive(name, values); }
};

struct Outer {
    int count = 0;
    bool flag = false;
    std::array<Inner, 2> pair;
    std::vector<Inner> list;
    std::vector<std::pair<std::string, std::string>> words;
    void transfer(Archive& archive) { archive(count, flag, pair, list, words); }
};

Outer example() {
    Outer outer;
    outer.count = -7;
    outer.flag = true;
    outer.pair = {Inner{"a", {1.0F, std::numeric_limits<float>::quiet_NaN()}}, Inner{"", {}}};
    outer.list = {Inner{"list", {3.0F}}, Inner{std::string("z\0z", 3), {}}};
    outer.words = {{"key", "value"}};
    return outer;
}

std::vector<char> bytes_of(Outer outer) {
    Archive archive;
    archive(outer);
    return archive.take();
}

TEST(Archive, WhatIsReadIsWhatWasWritten) {
    const std::vector<char> bytes = bytes_of(example());
    Archive archive(bytes);
    Outer read;
    archive(read);
    EXPECT_EQ(archive.remaining(), 0U);
    EXPECT_EQ(read.list[1].name.size(), 3U);
    EXPECT_EQ(read.words, example().words);
    EXPECT_EQ(bytes_of(read), bytes) << "NaN and all";
}

TEST(Archive, EveryTruncationIsAnError) {
    const std::vector<char> bytes = bytes_of(example());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        Archive archive(std::vector<char>(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)));
        Outer read;
        EXPECT_THROW(archive(read), ArchiveError) << size;
    }
}

/// Sizes that no memory holds are refused, not allocated.
TEST(Archive, SizesBeyondTheBytesAreErrors) {
    for (const std::uint64_t size : {std::uint64_t{3}, std::uint64_t{1} << 40, std::numeric_limits<std::uint64_t>::max()}) {
        Archive written;
        std::uint64_t claimed = size;
        float value = 1;
        written(claimed, value, value);
        Archive archive(written.take());
        std::vector<float> read;
        EXPECT_THROW(archive(read), ArchiveError) << size;
    }
}

}  // namespace
