// What a start builds, as PoCL keeps it: the first start what a render needs and no more, a second start nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <thread>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

namespace fs = std::filesystem;

struct Built {
    std::set<std::string> programs, code;  // code: of a kernel, for one size of groups and grids
    bool marked = false;                   // a process beside the render has gone through its list

    bool operator==(const Built& other) const { return programs == other.programs && code == other.code; }
};

/// PoCL's folder holds program.bc of each program, and below it a folder of each kernel.
Built built(const fs::path& cache) {
    Built found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(cache)) {
        const std::string place = fs::relative(entry.path(), cache).string();
        if (entry.path().filename() == "program.bc") found.programs.insert(place);
        if (entry.path().extension() == ".so" && place.rfind("tempfile", 0) != 0) found.code.insert(place);
        found.marked = found.marked || place.rfind("pencil-", 0) == 0;
    }
    return found;
}

class Start : public testing::TestWithParam<std::vector<std::string>> {
protected:
    /// Renders with the cache `name`; `before`: the words of a command that runs it.
    Built render(const std::string& name, std::vector<std::string> command = {}) {
        fs::create_directories(folder_ / name);
        for (const std::string& word :
             {std::string(PENCIL_PROGRAM), std::string("render"), std::string(PENCIL_SOURCE_DIR) + "/scenes/cornell-box.xml",
              std::string("--resolution"), std::string("24x24"), std::string("-o"), (folder_ / "a.exr").string()})
            command.push_back(word);
        command.insert(command.end(), GetParam().begin(), GetParam().end());
        RunOptions options;
        options.environment["POCL_CACHE_DIR"] = (folder_ / name).string();
        const RunResult result = run(command, options);
        EXPECT_EQ(result.code, 0) << result.err;
        said_ = result.err.find("building kernels for ") != std::string::npos;
        return built(folder_ / name);
    }

    Folder folder_;
    bool said_ = false;  // that kernels are built
};

TEST_P(Start, ProcessesBesideBuildWhatTheRenderNeedsAndASecondStartNothing) {
    const Built alone = render("alone", {"taskset", "-c", "0"});
    if (alone.programs.empty()) GTEST_SKIP() << "the device keeps no PoCL cache";
    EXPECT_FALSE(said_) << "one core has nobody to help";
    EXPECT_LE(alone.programs.size(), 4U) << "every program costs each start about 20 ms, and the first 100 ms";
    const Built together = render("together");
    EXPECT_TRUE(said_ || std::thread::hardware_concurrency() < 2);
    EXPECT_TRUE(together == alone) << together.code.size() << " kernels instead of " << alone.code.size();
    const Built again = render("together");
    EXPECT_TRUE(again == together);
    EXPECT_TRUE(!together.marked || !said_);
}

INSTANTIATE_TEST_SUITE_P(Methods, Start,
                         testing::Values(std::vector<std::string>{"--time", "0.01"},
                                         std::vector<std::string>{"--method", "line", "--bounces", "2"},
                                         std::vector<std::string>{"--method", "hybrid", "--bounces", "2", "--rays", "1"}));

}  // namespace
}  // namespace pencil_test
