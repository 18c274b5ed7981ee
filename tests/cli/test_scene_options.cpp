// What users say about a scene's content, and what they are told of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

const char* const approximated =
    "<scene version=\"0.5.0\"><sensor type=\"perspective\"/>\n<bsdf type=\"irawan\" id=\"a\"/>\n<emitter type=\"collimated\"/>\n"
    "<shape type=\"cube\"><ref id=\"a\"/></shape><shape type=\"sphere\"><bsdf type=\"roughconductor\"/></shape></scene>";

TEST(SceneOptions, StrictMakesErrorsOfApproximations) {
    const Folder folder;
    const std::string scene = folder.write("a.xml", approximated);
    const RunResult loose = run_pencil({"info", scene}), strict = run_pencil({"info", scene, "--strict"});
    EXPECT_EQ(loose.code, 0) << loose.err;
    EXPECT_NE(loose.err.find("pencil: warning: "), std::string::npos);
    EXPECT_EQ(strict.code, 3);
    for (const char* part : {"a.xml:2: bsdf type \"irawan\"", "a.xml:3: emitter type \"collimated\""})
        EXPECT_NE(strict.err.find(part), std::string::npos) << strict.err;
    EXPECT_EQ(std::count(strict.err.begin(), strict.err.end(), '\n'), 2);  // an error each
}

TEST(SceneOptions, InfoNamesModelsAndLights) {
    const Folder folder;
    const RunResult result = run_pencil({"info", folder.write("a.xml", approximated)});
    for (const char* text : {"diffuse, albedo (0.5, 0.5, 0.5), two-sided", "conductor, index", "beckmann roughness 0.1"})
        EXPECT_NE(result.out.find(text), std::string::npos) << text << " in " << result.out;
}

TEST(SceneOptions, AllowOpensFolders) {
    const Folder folder;
    std::filesystem::create_directories(folder / "meshes");
    std::filesystem::create_directories(folder / "scenes");
    folder.write("meshes/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string scene = folder.write("scenes/a.xml",
                                           "<scene version=\"3.0.0\"><sensor type=\"perspective\"/><shape type=\"obj\">"
                                           "<string name=\"filename\" value=\"../meshes/a.obj\"/></shape></scene>");
    const RunResult refused = run_pencil({"info", scene});
    EXPECT_EQ(refused.code, 3);
    EXPECT_NE(refused.err.find("give --allow"), std::string::npos) << refused.err;
    EXPECT_EQ(run_pencil({"info", scene, "--allow", (folder / "meshes").string()}).code, 0);
    EXPECT_EQ(run_pencil({"info", scene, "--allow", (folder / "none").string()}).code, 3);
}

}  // namespace
}  // namespace pencil_test
