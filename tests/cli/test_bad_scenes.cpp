// Scene files that cannot be read end with status 3, name the file, and leave nothing behind.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

void expect_scene_error(const std::string& scene, const std::string& named) {
    const Folder folder;
    const RunResult result = run_pencil({"render", scene, "-o", (folder / "a.exr").string()});
    EXPECT_EQ(result.code, 3) << result.err;
    EXPECT_NE(result.err.find("pencil: error: "), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(named), std::string::npos) << result.err;
    EXPECT_TRUE(folder.names().empty());
    EXPECT_EQ(run_pencil({"info", scene}).code, 3);
}

TEST(BadScene, Missing) { expect_scene_error("/nonexistent/room.xml", "room.xml"); }

TEST(BadScene, Empty) {
    const Folder folder;
    expect_scene_error(folder.write("empty.xml", ""), "empty.xml");
}

TEST(BadScene, NotXml) {
    const Folder folder;
    expect_scene_error(folder.write("picture.xml", std::string("\x89PNG\r\n\x1a\n\0\0\0", 11)), "picture.xml");
}

TEST(BadScene, FolderInsteadOfFile) {
    const Folder folder;
    expect_scene_error(folder.path().string(), folder.path().filename().string());
}

TEST(BadScene, FifoIsRefusedWithoutWaiting) {
    const Folder folder;
    const std::string fifo = (folder / "pipe.xml").string();
    ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
    expect_scene_error(fifo, "pipe.xml");
}

TEST(BadScene, DeviceFileIsRefused) { expect_scene_error("/dev/zero", "/dev/zero"); }

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
