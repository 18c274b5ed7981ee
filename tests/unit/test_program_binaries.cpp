// Binaries of programs on disk: given back to the same program on the same driver, and to none other.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "cl/program_binaries.h"

namespace {

using namespace pencil;

class ProgramBinariesOnDisk : public testing::Test {
protected:
    void SetUp() override {
        before_ = std::getenv("XDG_CACHE_HOME") ? std::getenv("XDG_CACHE_HOME") : "";
        folder_ = std::filesystem::temp_directory_path() / ("pencil-binaries-" + std::to_string(getpid()));
        setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
    }
    void TearDown() override {
        std::filesystem::remove_all(folder_);
        before_.empty() ? unsetenv("XDG_CACHE_HOME") : setenv("XDG_CACHE_HOME", before_.c_str(), 1);
    }
    std::filesystem::path programs() const { return folder_ / "pencil" / "programs"; }
    std::filesystem::path folder_;
    std::string before_;
};

DeviceInfo device_of(const std::string& platform, const std::string& driver) {
    DeviceInfo info;
    info.platform = platform;
    info.name = "a device";
    info.driver = driver;
    return info;
}

const ProgramBinaries::Binary some{1, 2, 3, 0, 255};

TEST_F(ProgramBinariesOnDisk, AreOfOneProgramAndDriver) {
    const ProgramBinaries binaries(device_of("A platform", "1.0"));
    EXPECT_TRUE(binaries.find("-D A=1", "text").empty());
    binaries.keep("-D A=1", "text", some);
    EXPECT_EQ(binaries.find("-D A=1", "text"), some);
    EXPECT_TRUE(binaries.find("-D A=2", "text").empty());
    EXPECT_TRUE(binaries.find("-D A=1", "texts").empty());
    EXPECT_TRUE(ProgramBinaries(device_of("A platform", "1.1")).find("-D A=1", "text").empty());
    EXPECT_EQ(ProgramBinaries(device_of("A platform", "1.0")).find("-D A=1", "text"), some);
}

TEST_F(ProgramBinariesOnDisk, DamagedOnesAreNone) {
    const ProgramBinaries binaries(device_of("A platform", "1.0"));
    binaries.keep("", "text", some);
    const std::filesystem::path file = std::filesystem::directory_iterator(programs())->path();
    std::ifstream in(file, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    for (std::size_t i = 0; i < whole.size(); ++i) {
        std::string flipped = whole;
        flipped[i] = static_cast<char>(flipped[i] ^ 1);
        std::ofstream(file, std::ios::binary) << flipped;
        EXPECT_TRUE(binaries.find("", "text").empty()) << i;
        std::ofstream(file, std::ios::binary) << whole.substr(0, i);
        EXPECT_TRUE(binaries.find("", "text").empty()) << i;
    }
}

TEST_F(ProgramBinariesOnDisk, AreNotKeptForDriversThatKeepTheirOwn) {
    EXPECT_FALSE(ProgramBinaries(device_of("Portable Computing Language", "3.1")).is_on());
    EXPECT_FALSE(std::filesystem::exists(folder_));
}

TEST_F(ProgramBinariesOnDisk, AreNotTakenFromAFolderThatOthersMayWrite) {
    EXPECT_TRUE(ProgramBinaries(device_of("A platform", "1.0")).is_on());
    std::filesystem::permissions(programs(), std::filesystem::perms::all);
    EXPECT_FALSE(ProgramBinaries(device_of("A platform", "1.0")).is_on());
}

TEST_F(ProgramBinariesOnDisk, TheOldestAreRemoved) {
    const ProgramBinaries binaries(device_of("A platform", "1.0"));
    for (int i = 0; i < 210; ++i) binaries.keep("", std::to_string(i), some);
    const auto files = std::filesystem::directory_iterator(programs());
    EXPECT_EQ(std::distance(begin(files), end(files)), 200);
    EXPECT_EQ(binaries.find("", "209"), some);
}

TEST_F(ProgramBinariesOnDisk, AFullDiskOrNoFolderIsNoFailure) {
    std::ofstream(folder_) << "a file where the folder would be";
    const ProgramBinaries binaries(device_of("A platform", "1.0"));
    EXPECT_FALSE(binaries.is_on());
    binaries.keep("", "text", some);
    EXPECT_TRUE(binaries.find("", "text").empty());
}

}  // namespace
