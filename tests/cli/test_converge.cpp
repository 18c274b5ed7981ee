// `pencil converge` from outside, on a tiny scene: files, resuming, refusing to mix, and what happens without matplotlib.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/fixtures.h"
#include "cli/run_program.h"

namespace pencil_test {
namespace {

using Json = nlohmann::json;

class Converge : public testing::Test {
protected:
    std::vector<std::string> arguments(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> all{"converge", scene, "-o", out.string(), "--resolution", "24x16", "--methods", "sets"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    /// Without plots: they take longer than the runs.
    RunResult measure(const std::vector<std::string>& more) const {
        RunOptions options;
        options.environment["PENCIL_PYTHON"] = "/bin/false";
        return run_pencil(arguments(more), options);
    }
    std::vector<std::string> points() const { return lines_of(read_text(out / "points.csv")); }
    Json summary() const { return Json::parse(read_text(out / "summary.json")); }

    Folder folder;
    std::string scene = folder.write("room.xml", small_scene());
    std::filesystem::path out = folder / "out";
};

TEST_F(Converge, MeasuresResumesAndRefusesToMix) {
    const std::vector<std::string> short_run{"--longest", "0.1", "--seeds", "2", "--quiet"};
    RunResult result = run_pencil(arguments(short_run));
    ASSERT_EQ(result.code, 0) << result.err;
    const std::vector<std::string> rows = points();
    ASSERT_GE(rows.size(), 1U + 2 * (2 + 1)) << "0.03 and 0.1 s of the path tracer and one step of sets, two seeds each";
    EXPECT_EQ(rows[0].rfind("method,budget,seed,seconds,build_seconds,rmse,rel_mse", 0), 0U);
    EXPECT_EQ(rows[1].rfind("path-tracer,0,0,", 0), 0U);
    EXPECT_EQ(rows[2].rfind("sets,0,0,", 0), 0U);

    const Json json = summary();
    EXPECT_TRUE(json["finished"].get<bool>());
    EXPECT_EQ(json["size"], Json::array({24, 16}));
    EXPECT_GT(json["reference"]["noise_rel_mse"].get<double>(), 0);
    for (const Json& method : json["methods"]) {
        for (const Json& budget : method["budgets"]) {
            EXPECT_GT(budget["seconds"].get<double>(), 0);
            EXPECT_GT(budget["relative_error"].get<double>(), 0);
            EXPECT_GE(budget["noise"].get<double>(), 0);
            EXPECT_EQ(budget["seeds"], Json::array({0, 1}));
        }
    }
    const std::string html = read_text(out / "index.html");
    EXPECT_NE(html.find("</html>"), std::string::npos);
    EXPECT_NE(html.find("data:image/svg+xml"), std::string::npos) << result.err;
    EXPECT_NE(html.find("data:image/png"), std::string::npos);
    EXPECT_EQ(html.find("http"), std::string::npos) << "no external resources";

    // Resuming: nothing is missing, then a seed is.
    const std::string before = read_text(out / "points.csv"), reference = read_text(out / "reference.exr");
    ASSERT_EQ(measure(short_run).code, 0);
    EXPECT_EQ(read_text(out / "points.csv"), before);
    EXPECT_EQ(read_text(out / "reference.exr"), reference);
    ASSERT_EQ(measure({"--longest", "0.1", "--seeds", "3", "--quiet"}).code, 0);
    EXPECT_EQ(read_text(out / "points.csv").rfind(before, 0), 0U) << "finished rows stay as they are";
    EXPECT_EQ(points().size() - 1, (rows.size() - 1) * 3 / 2);

    // Not mixing.
    result = run_pencil({"converge", scene, "-o", out.string(), "--resolution", "16x16", "--quiet"});
    EXPECT_EQ(result.code, 2) << result.err;
    EXPECT_NE(result.err.find("another size"), std::string::npos) << result.err;
    folder.write("room.xml", small_scene(true, false));
    result = measure(short_run);
    EXPECT_EQ(result.code, 2) << result.err;
    EXPECT_NE(result.err.find("another scene"), std::string::npos) << result.err;
}

TEST_F(Converge, AnInterruptionLosesNoFinishedRun) {
    std::vector<std::string> command{PENCIL_PROGRAM};
    const std::vector<std::string> rest = arguments({"--longest", "0.1", "--seeds", "200"});
    command.insert(command.end(), rest.begin(), rest.end());
    RunOptions options;
    options.environment["PENCIL_PYTHON"] = "/bin/false";
    Child child(command, options);
    ASSERT_TRUE(child.wait_for_error_text("seed 1"));
    child.send(SIGINT);
    const RunResult stopped = child.wait();
    EXPECT_EQ(stopped.code, 7) << stopped.err;
    EXPECT_NE(stopped.err.find("the same command goes on from there"), std::string::npos) << stopped.err;
    const std::string before = read_text(out / "points.csv");
    ASSERT_GE(lines_of(before).size(), 1U + 2 + 1) << "a whole seed";
    EXPECT_FALSE(summary()["finished"].get<bool>());
    EXPECT_NE(read_text(out / "index.html").find("Unfinished"), std::string::npos);

    std::filesystem::remove(out / "points.csv");  // a result: what goes on is in runs.jsonl
    const RunResult resumed = measure({"--longest", "0.1", "--seeds", "2", "--quiet"});
    ASSERT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_EQ(read_text(out / "points.csv").rfind(before, 0), 0U);
    EXPECT_TRUE(summary()["finished"].get<bool>());
}

TEST_F(Converge, ACrashLosesOneRunAtMost) {
    const std::vector<std::string> short_run{"--longest", "0.1", "--seeds", "1", "--quiet"};
    ASSERT_EQ(measure(short_run).code, 0);
    const std::filesystem::path runs = out / "runs.jsonl";
    const std::string all = read_text(runs);
    std::filesystem::resize_file(runs, all.size() - 10);
    const RunResult resumed = measure(short_run);
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_NE(resumed.err.find("the line was cut off; its run is measured again"), std::string::npos) << resumed.err;
    const std::vector<std::string> before = lines_of(all), after = lines_of(read_text(runs));
    ASSERT_GE(after.size(), before.size()) << "how many more runs there are is for the clock to say";
    EXPECT_TRUE(std::equal(before.begin(), before.end() - 1, after.begin())) << "whole lines stay";
    const Json cut = Json::parse(before.back()), again = Json::parse(after[before.size() - 1]);
    for (const char* key : {"method", "budget", "seed"}) EXPECT_EQ(again.at(key), cut.at(key)) << key;
    EXPECT_EQ(points().size(), 1 + after.size());
}

TEST_F(Converge, AFolderOfAnOlderVersionIsRefused) {
    const std::vector<std::string> short_run{"--longest", "0.05", "--seeds", "1", "--quiet"};
    ASSERT_EQ(measure(short_run).code, 0);
    std::filesystem::remove(out / "runs.jsonl");
    const RunResult refused = measure(short_run);
    EXPECT_EQ(refused.code, 2) << refused.err;
    EXPECT_NE(refused.err.find("made by an older version of pencil"), std::string::npos) << refused.err;
    EXPECT_NE(refused.err.find("use another folder"), std::string::npos) << refused.err;
}

TEST_F(Converge, AGivenReference) {
    const std::string truth = (folder / "truth.exr").string();
    ASSERT_EQ(run({"oiiotool", "--pattern", "constant:color=1,1,1", "24x16", "3", "-o", truth}).code, 0);
    const std::vector<std::string> common{"--reference", truth, "--longest", "0.05", "--seeds", "1", "--quiet"};
    ASSERT_EQ(measure(common).code, 0);
    EXPECT_EQ(summary()["reference"]["file"], "truth.exr");
    EXPECT_TRUE(summary()["reference"]["noise_rel_mse"].is_null()) << "unknown";
    EXPECT_FALSE(std::filesystem::exists(out / "reference.exr"));

    ASSERT_EQ(run({"oiiotool", "--pattern", "constant:color=2,2,2", "24x16", "3", "-o", truth}).code, 0);
    const RunResult other = measure(common);
    EXPECT_EQ(other.code, 2) << other.err;
    EXPECT_NE(other.err.find("another reference"), std::string::npos) << other.err;

    ASSERT_EQ(run({"oiiotool", "--pattern", "constant:color=2,2,2", "8x8", "3", "-o", truth}).code, 0);
    const RunResult small = measure(common);
    EXPECT_EQ(small.code, 3) << small.err;
    EXPECT_NE(small.err.find("8x8"), std::string::npos) << small.err;
    EXPECT_NE(small.err.find("24x16"), std::string::npos) << small.err;
}

TEST_F(Converge, WithoutMatplotlibThePageSaysSo) {
    RunOptions options;
    options.environment["PENCIL_PYTHON"] = "/bin/false";
    const RunResult result = run_pencil(arguments({"--longest", "0.05", "--seeds", "1", "--quiet"}), options);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.err.find("python3-matplotlib"), std::string::npos) << result.err;
    const std::string html = read_text(out / "index.html");
    EXPECT_NE(html.find("python3-matplotlib"), std::string::npos);
    EXPECT_EQ(html.find("image/svg"), std::string::npos);
    EXPECT_GE(points().size(), 3U);
}

TEST_F(Converge, AFolderThatCannotBeWrittenIsRefusedBeforeWork) {
    for (const std::string& bad : {std::string("/proc/out"), scene, scene + "/out"}) {
        const RunResult result = run_pencil({"converge", scene, "-o", bad, "--resolution", "24x16"});
        EXPECT_EQ(result.code, 6) << bad << " " << result.err;
        EXPECT_EQ(result.err.find("warm-up"), std::string::npos) << bad;
    }
}

TEST_F(Converge, WrongOptionsAreRefused) {
    for (const auto& [option, value, message] :
         {std::tuple("--methods", "magic", "sets"), std::tuple("--seeds", "0", "1 to 1000"), std::tuple("--longest", "0", "above 0")}) {
        const RunResult result = run_pencil({"converge", scene, "-o", out.string(), option, value});
        EXPECT_EQ(result.code, 2) << option;
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    }
}

}  // namespace
}  // namespace pencil_test
