// What the experiment keeps in its folder: finished runs, their table, and what they were measured of.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "converge/identity.h"
#include "unit/run_points.h"
#include "util/error.h"

namespace pencil {
namespace {

namespace fs = std::filesystem;

class ConvergeFolder : public testing::Test {
protected:
    ConvergeFolder() {
        std::string name = (fs::temp_directory_path() / "pencil-converge-XXXXXX").string();
        folder = ::mkdtemp(name.data());
    }
    ~ConvergeFolder() override {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
    }
    std::string read(const std::string& name) const {
        std::ifstream stream(folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name, std::ios::binary) << text; }

    fs::path folder;
};

TEST_F(ConvergeFolder, PointsComeBack) {
    const fs::path file = folder / "runs.jsonl";
    EXPECT_TRUE(read_runs(file).points.empty());
    RunPoint first = point("sets", 3, 18446744073709551615U, 0.1234567890123456789, 1e-7), second = point("thesis", 0, 1, 2.5);
    first.options = R"(--pencils 27, "quoted")";
    first.excluded_pixels = 5;
    first.load = 1.25;
    second.psnr = INFINITY;
    second.lab_rms = NAN;
    append_run(file, first);
    append_run(file, second);
    const RunLog log = read_runs(file);
    EXPECT_EQ(log.warning, "");
    const std::vector<RunPoint>& points = log.points;
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[0].seed, first.seed);
    EXPECT_EQ(points[0].seconds, first.seconds);
    EXPECT_EQ(points[0].rel_mse, first.rel_mse);
    EXPECT_EQ(points[0].options, first.options);
    EXPECT_EQ(points[0].excluded_pixels, 5U);
    EXPECT_EQ(points[0].load, 1.25);
    EXPECT_EQ(points[0].stages, first.stages);
    EXPECT_EQ(points[1].psnr, INFINITY);
    EXPECT_TRUE(std::isnan(points[1].lab_rms));
    EXPECT_EQ(points[1].method, "thesis");
}

TEST_F(ConvergeFolder, ALineCutByACrashIsIgnoredAndWrittenAgain) {
    const fs::path file = folder / "runs.jsonl";
    append_run(file, point("sets", 0, 0, 1));
    const std::string whole = read("runs.jsonl");
    append_run(file, point("sets", 1, 0, 2));
    const std::string both = read("runs.jsonl");
    for (std::size_t length = whole.size(); length < both.size(); ++length) {
        const std::string torn = both.substr(0, length);
        write("runs.jsonl", torn);
        const RunLog log = read_runs(file);
        ASSERT_EQ(log.points.size(), 1U) << length;
        ASSERT_EQ(log.warning.find("runs.jsonl:2: the line was cut off") != std::string::npos, length > whole.size()) << log.warning;
        ASSERT_EQ(read("runs.jsonl"), torn) << "reading changes nothing";
        append_run(file, point("sets", 1, 0, 2));
        ASSERT_EQ(read("runs.jsonl"), both) << length;
    }
    write("runs.jsonl", whole.substr(0, 10));
    EXPECT_TRUE(read_runs(file).points.empty());
}

TEST_F(ConvergeFolder, DamagedRunsAreRefusedWithTheirLine) {
    const fs::path file = folder / "runs.jsonl";
    append_run(file, point("sets", 0, 0, 1));
    const std::string whole = read("runs.jsonl");
    for (const std::string damage : {"sets,one,0", "{}", "[1]", "", R"({"method":"sets","budget":"one"})"}) {
        write("runs.jsonl", whole + damage + "\n" + whole);
        try {
            read_runs(file);
            FAIL() << "accepted " << damage;
        } catch (const OutputError& error) {
            EXPECT_NE(std::string(error.what()).find("runs.jsonl:2"), std::string::npos) << error.what();
        }
    }
}

TEST(PointsTable, OneRowForEachRun) {
    RunPoint run = point("sets", 3, 1, 0.25, 0.04);
    run.options = R"(--pencils 27, "quoted")";
    run.psnr = INFINITY;
    EXPECT_EQ(points_csv({run}),
              "method,budget,seed,seconds,build_seconds,rmse,rel_mse,mean_ratio,psnr_db,lab_rms,excluded_pixels,load,options,stages\n"
              "sets,3,1,0.25,0,0.2,0.04,0.97,inf,0.2,0,0,\"--pencils 27, \"\"quoted\"\"\",\"pencil density=0.0625;direct light=0.125\"\n");
}

TEST_F(ConvergeFolder, RunsOfAnotherSceneOrReferenceAreNotMixed) {
    const std::vector<RunPoint> points{point("sets", 0, 0, 1)};
    EXPECT_NO_THROW(check_identity(folder, {{"scene", "a"}}, {})) << "an empty folder";
    EXPECT_THROW(check_identity(folder, {{"scene", "a"}}, points), UsageError) << "points of nobody knows what";
    write_identity(folder, {{"scene", "a"}, {"reference", "r"}});
    EXPECT_NO_THROW(check_identity(folder, {{"scene", "a"}}, points));
    EXPECT_THROW(check_identity(folder, {{"scene", "b"}}, points), UsageError);
    EXPECT_THROW(check_identity(folder, {{"scene", "a"}, {"reference", "s"}}, points), UsageError);
    EXPECT_NO_THROW(check_identity(folder, {{"scene", "b"}}, {})) << "nothing to mix with";
}

TEST_F(ConvergeFolder, RunsWithOtherOptionsAreNotMixed) {
    write_identity(folder, {{"scene", "a"}});
    RunPoint run = point("sets", 0, 0, 1);
    run.options = "--pencils 7";
    EXPECT_THROW(check_identity(folder, {{"scene", "a"}}, {run}), UsageError);
    run.method = "of a later version";
    EXPECT_NO_THROW(check_identity(folder, {{"scene", "a"}}, {run}));
}

}  // namespace
}  // namespace pencil
