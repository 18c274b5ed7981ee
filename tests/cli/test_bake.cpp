// `pencil bake` and `pencil render --field` from outside.
#include <gtest/gtest.h>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

TEST(Bake, AFieldIsShown) {
    const Folder folder;
    const std::string scene = folder.write("scene.xml", small_scene()), field = (folder / "field.exr").string();
    for (const std::string from : {"reference", "line"}) {
        const RunResult baked = run_pencil({"bake", scene, "-o", field, "--from", from, "--pencils", "8", "--map", "8", "--spp", "4"});
        ASSERT_EQ(baked.code, 0) << baked.err;
        EXPECT_NE(baked.out.find("8 pencils with maps of 8 x 8 texels by " + from), std::string::npos) << baked.out;
        std::vector<std::string> command{"render", scene, "-o", (folder / "image.exr").string(), "--field", field};
        command.insert(command.end(), {"--light-samples", "4", "--film-samples", "4"});
        const RunResult shown = run_pencil(command);
        EXPECT_EQ(shown.code, 0) << shown.err;
    }
}

TEST(Bake, WhatIsNoFieldOrCannotBeOneIsRefused) {
    const Folder folder;
    const std::string scene = folder.write("scene.xml", small_scene()), dark = folder.write("dark.xml", small_scene(false));
    const std::string text = folder.write("text.exr", "no picture"), image = (folder / "image.exr").string();
    EXPECT_EQ(run_pencil({"render", scene, "-o", image, "--field", text}).code, 3);
    EXPECT_EQ(run_pencil({"render", scene, "-o", image, "--field", (folder / "none.exr").string()}).code, 3);
    EXPECT_EQ(run_pencil({"render", scene, "-o", image, "--field", text, "--method", "surface"}).code, 2);
    const RunResult both = run_pencil({"render", scene, "-o", image, "--field", text, "--pencils", "9"});
    EXPECT_EQ(both.code, 2);
    EXPECT_NE(both.err.find("--pencils"), std::string::npos) << both.err;
    EXPECT_EQ(run_pencil({"bake", scene, "-o", (folder / "field.png").string()}).code, 2);
    const RunResult nothing = run_pencil({"bake", dark, "-o", image, "--pencils", "8", "--map", "8", "--spp", "1"});
    EXPECT_EQ(nothing.code, 3);
    EXPECT_NE(nothing.err.find("nothing to bake"), std::string::npos) << nothing.err;
}

}  // namespace
}  // namespace pencil_test
