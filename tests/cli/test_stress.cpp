// `pencil stress` from outside: which cases it runs, what it refuses, and its exit status.
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

using Json = nlohmann::json;

/// A case of a tenth of a second, without a device's kernels.
const std::string quick_case = "radiance-1e30-reference";

TEST(Stress, RunsTheNamedCasesOnceEach) {
    const RunResult result = run_pencil({"stress", "--case", quick_case, "--case", quick_case, "--json"});
    ASSERT_EQ(result.code, 0) << result.err;
    const Json cases = Json::parse(result.out)["cases"];
    ASSERT_EQ(cases.size(), 1U);
    EXPECT_EQ(cases[0]["name"], quick_case);
    EXPECT_EQ(cases[0]["verdict"], "holds");
}

TEST(Stress, RefusesWhatMakesNoSense) {
    const auto refused = [](const std::vector<std::string>& more, const std::string& message) {
        std::vector<std::string> command{"stress"};
        command.insert(command.end(), more.begin(), more.end());
        const RunResult result = run_pencil(command);
        EXPECT_EQ(result.code, 2) << result.err;
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
        return result.err;
    };
    const std::string names = refused({"--case", "furnace"}, "no stress case \"furnace\"; there are");
    for (const char* name : {"radiance-1e30-surface", "furnace-0.99", "maze-line", "bound-dust"})
        EXPECT_NE(names.find(name), std::string::npos) << names;
    refused({"--json", "--markdown"}, "--json excludes --markdown");
    refused({"--all", "--case", quick_case}, "--all excludes --case");
}

/// What the image shows is doubled on its way out.
TEST(Stress, ACaseThatDoesNotHoldIsExitStatus9) {
    const Folder folder;
    const std::filesystem::path kernels = folder / "kernels";
    std::filesystem::copy(PENCIL_SOURCE_DIR "/kernels", kernels, std::filesystem::copy_options::recursive);
    std::string resolve = read_text(kernels / "resolve_film.cl");
    const std::string right = "(sum + steps) / norm", wrong = "2.0f * (sum + steps) / norm";
    ASSERT_NE(resolve.find(right), std::string::npos);
    folder.write("kernels/resolve_film.cl", resolve.replace(resolve.find(right), right.size(), wrong));
    RunOptions options;
    options.environment["PENCIL_KERNEL_DIR"] = kernels.string();
    const RunResult result = run_pencil({"stress", "--case", "film-1x1-surface"}, options);
    EXPECT_EQ(result.code, 9) << result.out << result.err;
    EXPECT_NE(result.out.find("FAILS"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("0 cases hold, 1 fail"), std::string::npos) << result.out;
}

TEST(Stress, AnInterruptionKeepsWhatIsFinished) {
    Child child({PENCIL_PROGRAM, "stress", "--case", quick_case, "--case", "bound-eye-in-a-sphere"});
    ASSERT_TRUE(child.wait_for_output_text(quick_case));
    child.send(SIGINT);
    const RunResult result = child.wait();
    EXPECT_EQ(result.code, 7) << result.err;
    EXPECT_NE(result.out.find("1 cases hold"), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find("bound-eye"), std::string::npos) << result.out;
    EXPECT_NE(result.err.find("interrupted after 1 of 2 cases"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace pencil_test
