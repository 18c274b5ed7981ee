// The command line: help, version, and that every wrong use ends with status 2 and a message that names the option and its range.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "cli/run_program.h"

namespace pencil_test {
namespace {

struct Refusal {
    std::vector<std::string> arguments;
    std::string message;
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.message; }

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, WithStatus2AndTheReason) {
    const RunResult result = run_pencil(GetParam().arguments);
    EXPECT_EQ(result.code, 2) << result.err;
    EXPECT_NE(result.err.find("pencil: error: "), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(GetParam().message), std::string::npos) << result.err;
    EXPECT_TRUE(result.out.empty()) << result.out;
}

Refusal option(const std::string& name, const std::string& value, const std::string& message) {
    return {{"render", "a.xml", "-o", "/tmp/pencil-never-written.exr", name, value}, message};
}

INSTANTIATE_TEST_SUITE_P(CommandLine, Refused,
                         testing::Values(Refusal{{}, "a command is required"}, Refusal{{"paint"}, "paint"}, Refusal{{"render"}, "SCENE"},
                                         Refusal{{"render", "a.xml"}, "--output"}, Refusal{{"render", "a.xml", "-o"}, "--output"},
                                         Refusal{{"render", "a.xml", "b.xml", "-o", "a.exr"}, "b.xml"},
                                         Refusal{{"render", "a.xml", "-o", "a.exr", "--fast"}, "--fast"},
                                         Refusal{{"render", "a.xml", "-o", "a.tiff"}, ".exr or .png"},
                                         Refusal{{"render", "a.xml", "-o", "a"}, ".exr or .png"}, Refusal{{"info"}, "SCENE"},
                                         Refusal{{"devices", "extra"}, "extra"}));

INSTANTIATE_TEST_SUITE_P(
    Together, Refused,
    testing::Values(
        Refusal{{"render", "a.xml", "-o", "a.exr", "--time", "3", "--map", "16"},
                "--time excludes --map: one is an option of --method surface, the other of line, hybrid"},
        Refusal{{"render", "a.xml", "-o", "a.exr", "--rays", "16", "--weights", "voronoi"},
                "--weights excludes --rays: one is an option of --method line, the other of hybrid"},
        Refusal{{"render", "a.xml", "-o", "a.exr", "--field", "f.exr", "--time", "3"}, "--time excludes --field"},
        Refusal{{"render", "a.xml", "-o", "a.exr", "--method", "surface", "--map", "16"}, "--map: is not an option of --method surface"},
        Refusal{{"render", "a.xml", "-o", "a.exr", "--field", "f.exr", "--bounces", "2"}, "--bounces: is decided by the --field"},
        Refusal{{"bake", "a.xml", "-o", "f.exr", "--pencils", "65536", "--map", "128"}, "takes 12.0 GiB"},
        Refusal{{"bake", "a.xml", "-o", "f.exr", "--pencils", "65536", "--map", "1024"}, "fewer --pencils or a smaller --map"}));

INSTANTIATE_TEST_SUITE_P(
    Values, Refused,
    testing::Values(option("--pencils", "0", "1 to 1048576"), option("--pencils", "-1", "1 to 1048576"),
                    option("--pencils", "1e99", "1 to 1048576"), option("--pencils", "16x", "1 to 1048576"),
                    option("--pencils", "", "1 to 1048576"), option("--pencils", "99999999999999999999", "1 to 1048576"),
                    option("--decay", "0", "above 0 and at most 1"), option("--decay", "1.01", "above 0 and at most 1"),
                    option("--decay", "nan", "above 0 and at most 1"), option("--decay", "0,7", "above 0 and at most 1"),
                    option("--tolerance", "-1", "above 0 and at most 1"), option("--tolerance", "inf", "above 0 and at most 1"),
                    option("--bounces", "-2", "0 to 1000"), option("--bounces", "all", "0 to 1000"), option("--map", "4", "8 to 1024"),
                    option("--map", "33", "not a multiple of 8"), option("--light-samples", "0", "1 to 1048576"),
                    option("--film-samples", "0", "1 to 64"), option("--initial", "none", "direct, emission, auto"),
                    option("--placement", "grid", "random, lds"), option("--placement", "lds+", "random, lds"),
                    option("--placement", "lds+profile+lds", "names lds twice"),
                    option("--weights", "equal", "dpdf, voronoi, analytic, thesis"), option("--iterate", "once", "sets, fixed, levels"),
                    option("--rays", "577", "1 to 576"), option("--resolution", "0x0", "WIDTHxHEIGHT"),
                    option("--resolution", "64", "WIDTHxHEIGHT"), option("--resolution", "64x", "WIDTHxHEIGHT"),
                    option("--resolution", "64x-3", "WIDTHxHEIGHT"), option("--resolution", "1000001x1", "1 to 1000000"),
                    option("--seed", "-1", "18446744073709551615"), option("--aov", "colour", "emission, direct"),
                    option("--aov", "", "emission, direct"), option("-D", "depth", "name=value"), option("-D", "=3", "name=value")));

TEST(Usage, AnOptionGivenTwiceIsRefused) {
    const RunResult result = run_pencil({"render", "a.xml", "-o", "a.exr", "--pencils", "4", "--pencils", "5"});
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.err.find("--pencils"), std::string::npos) << result.err;
}

TEST(Usage, HelpNamesEveryCommandAndOption) {
    const RunResult general = run_pencil({"--help"});
    EXPECT_EQ(general.code, 0);
    for (const char* word : {"render", "reference", "compare", "converge", "info", "devices", "--version", "Exit status"})
        EXPECT_NE(general.out.find(word), std::string::npos) << word;
    const RunResult render = run_pencil({"render", "--help"});
    EXPECT_EQ(render.code, 0);
    for (const char* word :
         {"--output",  "--pencils", "--decay",     "--bounces",      "--map",  "--light-samples", "--initial", "--placement",
          "--weights", "--iterate", "--tolerance", "--resolution",   "--seed", "--device",        "--aov",     "--define",
          "--stats",   "--explain", "--quiet",     "--film-samples", "--rays", "--least-pencils"})
        EXPECT_NE(render.out.find(word), std::string::npos) << word;
    EXPECT_TRUE(render.err.empty()) << render.err;
}

TEST(Usage, DocumentationOfOptionsIsTheProgramsOwn) {
    std::ifstream file(PENCIL_SOURCE_DIR "/docs/options.md");
    const std::string written((std::istreambuf_iterator<char>(file)), {});
    EXPECT_EQ(run_pencil({"document", "markdown"}).out, written) << "run scripts/document.sh";
    const std::string manual = run_pencil({"document", "man"}).out;
    for (const char* word : {".TH PENCIL 1", "\\-\\-light\\-samples N", "EXIT STATUS"})
        EXPECT_NE(manual.find(word), std::string::npos) << word;
}

TEST(Usage, VersionIsOneLine) {
    const RunResult result = run_pencil({"--version"});
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.out.rfind("pencil ", 0), 0U) << result.out;
    EXPECT_EQ(result.out.find('\n'), result.out.size() - 1) << result.out;
}

TEST(Usage, ControlCharactersOfArgumentsDoNotReachTheTerminal) {
    const RunResult result = run_pencil({"render", "a.xml", "-o", "a\x1b[31m\xc2\x9b.exr", "--map", "\x1b]0;title\x07"});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.err.find_first_of("\x1b\x07"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace pencil_test
