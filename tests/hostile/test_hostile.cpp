// Each case of the corpus ends as it must: no crash, the exit status of docs/usage.md with a message that says why, within 5 s and 300 MB more than
// the same command takes for a small scene, and without a trace where it failed.
#include <gtest/gtest.h>

#include <algorithm>

#include "hostile/hostile_case.h"

namespace pencil_test {
namespace {

constexpr double longest = 5;                    // [s] of the processor, so that neighbours on the machine do not count
constexpr long most_memory = 300 * 1000 * 1000;  // [bytes]

/// What the command takes where nothing is wrong [bytes].
long usual_memory(const std::string& command) {
    static std::map<std::string, long> known;
    if (known.count(command) == 0) {
        const Folder folder;
        Arguments arguments{command, folder.write("scene.xml", small_scene())};
        if (command == "render") {
            arguments.insert(arguments.end(), quick().begin(), quick().end());
            arguments.insert(arguments.end(), {"-o", (folder / "a.exr").string()});
        }
        known[command] = run_pencil(arguments).peak_memory;
    }
    return known[command];
}

class Hostile : public testing::TestWithParam<HostileCase> {};

TEST_P(Hostile, EndsAsItMust) {
    const HostileCase& hostile = GetParam();
    const Folder folder;
    const Arguments arguments = hostile.make(folder);
    std::vector<std::string> before = folder.names();
    RunOptions options;
    options.environment = hostile.environment;
    const RunResult result = run_pencil(arguments, options);
    const std::string said = result.err.substr(0, 2000);
    EXPECT_EQ(result.signal, 0) << said;
    EXPECT_EQ(result.code, hostile.code) << said;
    EXPECT_NE((result.err + (hostile.code == 0 ? result.out : "")).find(hostile.says), std::string::npos) << said;
    EXPECT_EQ(result.err.find("pencil: error: ") == std::string::npos, hostile.code == 0) << said;
    EXPECT_LT(result.err.size(), 20000U) << said;
    EXPECT_EQ(result.err.find('\x1b'), std::string::npos) << said;
    EXPECT_LE(result.processor_time, longest);
    EXPECT_LE(result.peak_memory - usual_memory(arguments.front()), most_memory) << said;
    if (hostile.code == 0) before = folder.names();
    EXPECT_EQ(folder.names(), before);
}

std::string name_of(const testing::TestParamInfo<HostileCase>& info) {
    std::string name = "row_" + info.param.name;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Hostile, testing::ValuesIn(hostile_scenes()), name_of);
INSTANTIATE_TEST_SUITE_P(Meshes, Hostile, testing::ValuesIn(hostile_meshes()), name_of);
INSTANTIATE_TEST_SUITE_P(Gltf, Hostile, testing::ValuesIn(hostile_gltf()), name_of);
INSTANTIATE_TEST_SUITE_P(Pictures, Hostile, testing::ValuesIn(hostile_pictures()), name_of);
INSTANTIATE_TEST_SUITE_P(Runs, Hostile, testing::ValuesIn(hostile_runs()), name_of);

}  // namespace

void PrintTo(const HostileCase& hostile, std::ostream* out) { *out << hostile.name; }

}  // namespace pencil_test
