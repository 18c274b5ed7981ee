// Where results go: refused before rendering if they cannot be stored, whole or absent afterwards, older ones never damaged.
#include <gtest/gtest.h>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

std::vector<std::string> render(const std::string& scene, std::vector<std::string> more) {
    std::vector<std::string> arguments{"render", scene, "--quiet"};
    arguments.insert(arguments.end(), quick().begin(), quick().end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

class Output : public testing::Test {
protected:
    void expect_refused(const std::vector<std::string>& more, const std::string& reason) {
        const RunResult result = run_pencil(render(scene, more));
        EXPECT_EQ(result.code, 6) << result.err;
        EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
    }

    Folder folder;
    std::string scene = folder.write("room.xml", small_scene());
    std::string image = (folder / "a.exr").string();
};

TEST_F(Output, MissingFolder) { expect_refused({"-o", (folder / "none/a.exr").string()}, "does not exist"); }

TEST_F(Output, FileInPlaceOfAFolder) { expect_refused({"-o", scene + "/a.exr"}, "not a folder"); }

TEST_F(Output, FolderInPlaceOfTheFile) {
    std::filesystem::create_directory(image);
    expect_refused({"-o", image}, "not a regular file");
}

TEST_F(Output, FolderThatNobodyCanWriteTo) {
    expect_refused({"-o", "/proc/a.exr"}, "/proc/a.exr");  // holds for root, too
}

TEST_F(Output, SameFileTwice) {
    expect_refused({"-o", image, "-o", (folder / "./a.exr").string()}, "named twice");
    expect_refused({"-o", image, "--stats", image}, "named twice");
}

TEST_F(Output, TheSceneItself) {
    const std::string before = read_text(scene);
    expect_refused({"-o", image, "--stats", scene}, "it is the scene");
    std::filesystem::create_symlink(scene, image);
    expect_refused({"-o", image}, "it is the scene");
    EXPECT_EQ(read_text(scene), before);
}

TEST_F(Output, RefusedOutputsLeaveOlderResultsAndNoTemporaryFiles) {
    folder.write("a.exr", "older");
    expect_refused({"-o", image, "-o", (folder / "none/b.png").string()}, "does not exist");
    EXPECT_EQ(read_text(image), "older");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.exr", "room.xml"}));
}

TEST_F(Output, DiskThatFillsUpWhileWriting) {
    const std::vector<std::string> large = render(scene, {"-o", image, "--resolution", "600x400", "--bounces", "2"});
    ASSERT_EQ(run_pencil(large).code, 0);  // builds the kernels: the driver writes larger files while it does
    const std::string before = read_text(image);
    RunOptions full;
    full.largest_file = 1 << 21;  // [bytes]; the driver's own temporary files are just below
    ASSERT_GT(before.size(), std::size_t(full.largest_file));
    const RunResult result = run_pencil(large, full);
    EXPECT_EQ(result.code, 6) << result.err;
    EXPECT_NE(result.err.find("cannot write " + image), std::string::npos) << result.err;
    EXPECT_EQ(read_text(image), before);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.exr", "room.xml"}));
}

TEST_F(Output, StandardOutputThatIsFull) {
    RunOptions full;
    full.output = "/dev/full";
    EXPECT_EQ(run_pencil({"info", scene}, full).code, 6);
}

TEST_F(Output, SymbolicLinksStayLinks) {
    const std::string target = folder.write("target.exr", "older");
    std::filesystem::create_symlink("target.exr", image);
    ASSERT_EQ(run_pencil(render(scene, {"-o", image})).code, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(image));
    EXPECT_NE(image_info(target).find("24 x   16"), std::string::npos) << image_info(target);
}

TEST_F(Output, AnImageLargerThanMemory) {
    const RunResult result = run_pencil(render(scene, {"-o", image, "--resolution", "1000000x1000000"}));
    EXPECT_EQ(result.code, 5) << result.err;
    EXPECT_NE(result.err.find("TiB"), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(image));
}

}  // namespace
}  // namespace pencil_test
