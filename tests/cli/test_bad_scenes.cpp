// Scene files and what `info` says of them. Hostile ones stand in tests/hostile.
#include <gtest/gtest.h>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

TEST(BadScene, TruncatedAnywhere) {
    const Folder folder;
    const std::string whole = small_scene();
    const std::size_t last = whole.rfind("</scene>");
    const std::size_t step = last / 12;
    for (std::size_t length = 1; length < last; length += step) {
        const RunResult result = run_pencil({"info", folder.write("cut.xml", whole.substr(0, length))});
        EXPECT_EQ(result.code, 3) << "cut after " << length << " bytes: " << result.out << result.err;
    }
}

TEST(BadScene, NamesAreEscaped) {
    const Folder folder;
    const RunResult result = run_pencil({"info", folder.write("a\x1b[31m.xml", "<scene version=\"3.0.0\"><nonsense\x1b[31m/></scene>")});
    EXPECT_EQ(result.code, 3);
    EXPECT_EQ(result.err.find('\x1b'), std::string::npos) << result.err;
}

TEST(Info, ListsWhatTheSceneHolds) {
    const Folder folder;
    const RunResult result = run_pencil({"info", folder.write("room.xml", small_scene()), "-D", "depth=5"});
    EXPECT_EQ(result.code, 0) << result.err;
    for (const char* text : {"triangles  6", "shapes     3", "floor", "lamp", "1 area, 0 point", "24x16", "max_depth  5", "bounds",
                             "needed    area emitters", "left out  point lights"})
        EXPECT_NE(result.out.find(text), std::string::npos) << text << "\n" << result.out;
}

}  // namespace
}  // namespace pencil_test
