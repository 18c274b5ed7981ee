// `pencil bake` and `pencil render --field` from outside.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

TEST(Bake, AFieldIsShown) {
    const Folder folder;
    const std::string scene = folder.write("scene.xml", small_scene()), field = (folder / "field.exr").string();
    for (const std::string from : {"reference", "surface", "line"}) {
        const RunResult baked = run_pencil({"bake", scene, "-o", field, "--from", from, "--pencils", "8", "--map", "8", "--spp", "4"});
        ASSERT_EQ(baked.code, 0) << baked.err;
        EXPECT_NE(baked.out.find("8 pencils with maps of 8 x 8 texels by " + from), std::string::npos) << baked.out;
        std::vector<std::string> command{"render", scene, "-o", (folder / "image.exr").string(), "--field", field};
        command.insert(command.end(), {"--light-samples", "4", "--film-samples", "4"});
        const RunResult shown = run_pencil(command);
        EXPECT_EQ(shown.code, 0) << shown.err;
    }
}

TEST(Walk, WritesAnImageForEachView) {
    const Folder folder;
    const std::string scene = folder.write("scene.xml", small_scene()), field = (folder / "field.exr").string();
    ASSERT_EQ(run_pencil({"bake", scene, "-o", field, "--pencils", "8", "--map", "8", "--spp", "4"}).code, 0);
    const auto walk = [&](const std::string& views) {
        return run_pencil({"walk", scene, "--field", field, "--views", folder.write("views.txt", views), "-o",
                           (folder / "image.exr").string(), "--resolution", "16x16", "--film-samples", "4", "--light-samples", "4"});
    };
    const RunResult walked = walk("# place, target, upwards\n0 0 3, 0 0 0\n\n0.1,0,2.5,0,0,0,0,1,0 # nearer\n");
    ASSERT_EQ(walked.code, 0) << walked.err;
    EXPECT_NE(walked.out.find("wrote 2 views"), std::string::npos) << walked.out;
    for (const char* name : {"image-0001.exr", "image-0002.exr"}) EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
    const auto refused = [&](const std::string& views, const std::string& what) {
        const RunResult result = walk(views);
        EXPECT_EQ(result.code, 3);
        EXPECT_NE(result.err.find(what), std::string::npos) << result.err;
    };
    const RunResult over = run_pencil({"walk", scene, "--field", (folder / "image-0001.exr").string(), "--views",
                                       (folder / "views.txt").string(), "-o", (folder / "image.exr").string()});
    EXPECT_EQ(over.code, 6);
    EXPECT_NE(over.err.find("image-0001.exr: it is read"), std::string::npos) << over.err;
    refused("0,0,3,0,0\n", "views.txt:1: 5 numbers where 6 or 9 are expected");
    refused("\n0,0,3,0,0,x\n", "views.txt:2");
    refused("0,0,3,0,0,3\n", "cannot look at where it stands");
    refused("0,0,3,0,0,0,0,0,1\n", "upward direction");
    refused("# nothing\n", "holds no view");
}

TEST(Walk, ReadsNoMorePencilsThanAView) {
    const Folder folder;
    const std::string scene = folder.write("scene.xml", small_scene()), field = (folder / "field.exr").string();
    ASSERT_EQ(run_pencil({"bake", scene, "-o", field, "--pencils", "8", "--map", "8", "--spp", "4"}).code, 0);
    const RunResult walked =
        run_pencil({"walk", scene, "--field", field, "--field-pencils", "3", "--views", folder.write("views.txt", "0 0 3, 0 0 0\n"), "-o",
                    (folder / "image.exr").string(), "--resolution", "16x16", "--film-samples", "4", "--light-samples", "4"});
    ASSERT_EQ(walked.code, 0) << walked.err;
    EXPECT_NE(walked.out.find("3 of 8 pencils were read"), std::string::npos) << walked.out;
    const std::string image = (folder / "part.exr").string();
    EXPECT_EQ(run_pencil({"render", scene, "-o", image, "--field", field, "--field-pencils", "3", "--method", "hybrid", "--resolution",
                          "16x16", "--film-samples", "4", "--light-samples", "4"})
                  .code,
              0);
    const RunResult without = run_pencil({"render", scene, "-o", image, "--field-pencils", "3"});
    EXPECT_EQ(without.code, 2);
    EXPECT_NE(without.err.find("--field-pencils: is an option of --field"), std::string::npos) << without.err;
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
    const RunResult kind = run_pencil({"render", scene, "-o", image, "--field", text, "--map-kind", "cube"});
    EXPECT_EQ(kind.code, 2);
    EXPECT_NE(kind.err.find("--map-kind"), std::string::npos) << kind.err;
    const RunResult no_maps = run_pencil({"render", scene, "-o", image, "--method", "surface", "--map-kind", "cube"});
    EXPECT_EQ(no_maps.code, 2);
    EXPECT_NE(no_maps.err.find("--map-kind: is not an option of --method surface"), std::string::npos) << no_maps.err;
    EXPECT_EQ(run_pencil({"bake", scene, "-o", image, "--map-kind", "cube"}).code, 2) << "fields are octahedral";
    EXPECT_EQ(run_pencil({"bake", scene, "-o", (folder / "field.png").string()}).code, 2);
    const RunResult nothing = run_pencil({"bake", dark, "-o", image, "--pencils", "8", "--map", "8", "--spp", "1"});
    EXPECT_EQ(nothing.code, 3);
    EXPECT_NE(nothing.err.find("nothing to bake"), std::string::npos) << nothing.err;
}

TEST(Bake, DirectLightAloneIsNothingToBake) {
    const Folder folder;
    const std::string scene = folder.write("scene.xml", small_scene()), field = (folder / "field.exr").string();
    for (const std::string from : {"reference", "surface", "hybrid", "line"})
        for (const std::string depth : {"1", "2"}) {
            const RunResult result = run_pencil({"bake", scene, "-D", "depth=" + depth, "-o", field, "--from", from});
            EXPECT_EQ(result.code, 3);
            EXPECT_NE(result.err.find("max_depth of " + depth + " leaves no light"), std::string::npos) << result.err;
        }
}

TEST(Bake, TheFieldDecidesHowOftenLightIsReflected) {
    const Folder folder;
    const std::string scene = folder.write("scene.xml", small_scene()), field = (folder / "field.exr").string();
    const RunResult baked =
        run_pencil({"bake", scene, "-D", "depth=4", "-o", field, "--pencils", "8", "--map", "8", "--spp", "4", "--quiet"});
    ASSERT_EQ(baked.code, 0) << baked.err;
    for (const std::string depth : {"4", "2", "-1"}) {
        const RunResult shown = run_pencil({"render", scene, "-D", "depth=" + depth, "-o", (folder / "image.exr").string(), "--field",
                                            field, "--light-samples", "4", "--film-samples", "4"});
        EXPECT_EQ(shown.code, 0) << shown.err;
        const bool said = shown.err.find("max_depth of " + depth + " does not count") != std::string::npos;
        EXPECT_EQ(said, depth != "4") << shown.err;
    }
}

/// Mean of the beauty over that of the reference.
double mean_ratio(const std::string& image, const std::string& reference) {
    const RunResult compared = run_pencil({"compare", image, reference, "--json"});
    return nlohmann::json::parse(compared.out)["layers"][0]["mean_ratio"].get<double>();
}

TEST(Bake, ARoomWithALampIsAsBrightAsByLightPaths) {
    const Folder folder;
    const std::string scene = std::string(PENCIL_SOURCE_DIR) + "/scenes/cornell-box.xml";
    const auto file = [&folder](const std::string& name) { return (folder / name).string(); };
    const std::vector<std::string> film{"--resolution", "48x48", "--aov", "none", "--quiet"};
    const auto run = [&film](std::vector<std::string> command, const std::string& depth, bool has_film) {
        command.insert(command.end(), {"-D", "max_depth=" + depth});
        if (has_film) command.insert(command.end(), film.begin(), film.end());
        const RunResult result = run_pencil(command);
        EXPECT_EQ(result.code, 0) << result.err;
    };
    run({"reference", scene, "-o", file("truth.exr"), "--spp", "256"}, "4", true);
    run({"reference", scene, "-o", file("less.exr"), "--spp", "256"}, "3", true);
    EXPECT_LT(mean_ratio(file("less.exr"), file("truth.exr")), 0.95) << "an order more or less is seen";
    for (const std::string from : {"reference", "surface", "hybrid"}) {
        run({"bake", scene, "-o", file("field.exr"), "--from", from, "--pencils", "64", "--map", "32", "--quiet"}, "4", false);
        run({"render", scene, "-o", file("shown.exr"), "--field", file("field.exr"), "--method", "hybrid"}, "4", true);
        const double ratio = mean_ratio(file("shown.exr"), file("truth.exr"));
        std::printf("field by %s over light paths: %.4f\n", from.c_str(), ratio);
        EXPECT_NEAR(ratio, 1.0, 0.03) << "64 small maps lose 2 %";
    }
}

}  // namespace
}  // namespace pencil_test
