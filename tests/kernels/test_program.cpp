// Programs and launches: specialisation, caching, ranges, and messages a developer can act on.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>

#include "cl/embedded_kernels.h"
#include "cl/kernel_source.h"
#include "cl/program.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr const char* test_kernels = PENCIL_SOURCE_DIR "/tests/kernels/test_program.cl";

class Program : public testing::Test {
protected:
    Launch kernel(const std::string& name, const Defines& defines = {}) { return programs.kernel(name, test_kernels, defines); }

    std::string error_of(const std::function<void()>& f) {
        try {
            f();
        } catch (const DeviceError& error) {
            return error.what();
        }
        return "nothing was thrown";
    }

    void expect_contains(const std::string& text, const std::string& part) { EXPECT_NE(text.find(part), std::string::npos) << text; }

    // A program of one file that is written for the test.
    std::string write_file(const std::string& name, const std::string& text) {
        const std::filesystem::path path = folder / name;
        std::filesystem::create_directories(folder);
        std::ofstream(path) << text;
        return path.string();
    }

    void TearDown() override {
        unsetenv("PENCIL_KERNEL_DIR");
        unsetenv("PENCIL_DUMP_KERNELS");
        std::filesystem::remove_all(folder);
    }

    std::shared_ptr<Device> device = Device::open("");
    ProgramCache programs{device};
    std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / ("pencil_program_" + std::to_string(getpid()));
};

TEST_F(Program, EveryItemRunsOnceAtAnySize) {
    constexpr int capacity = 1100;
    for (const std::size_t count : {1u, 7u, 8u, 9u, 64u, 1000u}) {
        for (const std::size_t local : {0u, 1u, 3u, 16u}) {
            Buffer<int> counts(device, capacity, "counts");
            counts.fill_zero();
            kernel("count_visits").args(counts, static_cast<int>(count)).run(count, "counting", local);
            const std::vector<int> found = counts.read();
            for (std::size_t i = 0; i < found.size(); ++i)
                ASSERT_EQ(found[i], i < count ? 1 : 0) << "item " << i << " of " << count << ", local size " << local;
        }
    }
}

TEST_F(Program, EveryItemRunsOnceIn2d) {
    for (const auto& [width, height] : {std::pair{1, 1}, std::pair{17, 5}, std::pair{64, 33}}) {
        Buffer<int> counts(device, static_cast<std::size_t>(width * height), "counts");
        counts.fill_zero();
        kernel("count_visits_2d").args(counts, width, height).run2d(width, height, 8, 4, "counting in 2d");
        EXPECT_EQ(counts.read(), std::vector<int>(static_cast<std::size_t>(width * height), 1)) << width << "x" << height;
    }
}

TEST_F(Program, NothingIsLaunchedForNothing) {
    Buffer<int> counts(device, 0, "no counts");
    kernel("count_visits").args(counts, 0).run(0, "nothing");
    kernel("count_visits_2d").args(counts, 0, 5).run2d(0, 5, 8, 8, "nothing");
    EXPECT_TRUE(device->launch_times().empty());
}

TEST_F(Program, DefinesSpecialiseAndProgramsAreReused) {
    Buffer<int> counts(device, 10, "counts");
    counts.fill_zero();
    kernel("count_visits", {{"TEST_STEP", "5"}}).args(counts, 10).run(10, "counting");
    kernel("count_visits", {{"TEST_STEP", "7"}}).args(counts, 10).run(10, "counting");
    EXPECT_EQ(counts.read(), std::vector<int>(10, 12));
    const double before = device->build_seconds();
    EXPECT_GT(before, 0.0);
    kernel("count_visits", {{"TEST_STEP", "5"}}).args(counts, 10).run(10, "counting");
    EXPECT_EQ(device->build_seconds(), before) << "built or generated again";
    EXPECT_EQ(programs.built(), std::vector<std::string>{"count_visits"});
}

TEST_F(Program, PacketWidthIsDefinedAndCanBeGiven) {
    Buffer<int> out(device, 1, "width");
    kernel("report_width").args(out).run(1, "width");
    EXPECT_EQ(out.read().at(0), device->packet_width());
    kernel("report_width", {{"PENCIL_WIDTH", "1"}}).args(out).run(1, "width");
    EXPECT_EQ(out.read().at(0), 1);
}

TEST_F(Program, LaunchesKeepTheirOwnArguments) {
    Buffer<int> first(device, 10, "first"), second(device, 10, "second");
    first.fill_zero();
    second.fill_zero();
    Launch a = kernel("count_visits"), b = kernel("count_visits");
    a.args(first, 10);
    b.args(second, 5);
    a.run(10, "first");
    b.run(10, "second");
    EXPECT_EQ(first.read(), std::vector<int>(10, 1));
    EXPECT_EQ(second.read(5, 5), std::vector<int>(5, 0));
}

TEST_F(Program, RequiredGroupSizeIsUsedOrRefused) {
    Buffer<int> out(device, 3, "groups");
    kernel("groups_of_four").args(out).run(12, "groups");
    EXPECT_EQ(out.read(), std::vector<int>(3, 4));
    expect_contains(error_of([&] { kernel("groups_of_four").args(out).run(12, "groups", 2); }), "groups_of_four needs groups of 4x1");
}

TEST_F(Program, WrongArgumentsNameTheKernel) {
    Buffer<float> values(device, 4, "values");
    expect_contains(error_of([&] { kernel("scale").args(values, 4); }), "kernel scale takes 3 arguments and was given 2");
    expect_contains(error_of([&] { kernel("scale").args(values, 4, 2.0f, 1); }), "kernel scale takes 3 arguments and was given 4");
    expect_contains(error_of([&] { kernel("scale").args(values, 4, 2.0); }), "is a float and was given a double");
    expect_contains(error_of([&] { kernel("scale").args(Buffer<int>(device, 4, "counts"), 4, 2.0f); }),
                    "argument 0 of kernel scale, \"values\", is a buffer of float and was given a buffer of int");
    expect_contains(error_of([&] { kernel("scale").args(1.0f, 4, 2.0f); }), "is a buffer of float and was given a float");
    expect_contains(error_of([&] { kernel("scale").args(values, values, 2.0f); }),
                    "argument 1 of kernel scale, \"count\", is a int and was given a buffer of float");
    expect_contains(error_of([&] { kernel("scale").args(values, 2.0f, 4); }), "is a int and was given a float");
    EXPECT_EQ(error_of([&] { kernel("scale").args(std::make_tuple(std::cref(values), 4), 2.0f); }), "nothing was thrown")
        << "a group is its members";
}

TEST_F(Program, UnknownNamesAreReported) {
    expect_contains(error_of([&] { kernel("no_such_kernel"); }), "no kernel named no_such_kernel in");
    expect_contains(error_of([&] { programs.kernel("x", "lib/no_such_file.cl"); }), "no kernel file named lib/no_such_file.cl");
    expect_contains(error_of([&] { programs.kernel("x", "/no/such/file.cl"); }), "cannot read the kernel file /no/such/file.cl");
}

TEST_F(Program, BuildFailureTellsFileLineDeviceAndOptions) {
    const std::string file =
        write_file("broken.cl", "kernel void broken(global int *out)\n{\n    out[0] = TEST_STEP * no_such_variable;\n}\n");
    const std::string message = error_of([&] { programs.kernel("broken", file, {{"TEST_STEP", "3"}}); });
    expect_contains(message, "broken.cl failed");
    expect_contains(message, device->info().name);
    expect_contains(message, "-cl-std=CL1.2 -cl-kernel-arg-info -Werror");
    expect_contains(message, "-D TEST_STEP=3");
    expect_contains(message, "broken.cl:3:");
    expect_contains(message, "no_such_variable");
}

/// Scenes that differ in what a program does not look at share it.
TEST_F(Program, DefinesThatAreNotNamedAreLeftOut) {
    const std::string file =
        write_file("pasted.cl", "#define IS(NAME) TEST_IS_##NAME\nkernel void k(global int *out) { out[0] = IS(A_B) + broken; }\n");
    const std::string message = error_of([&] { programs.kernel("k", file, {{"TEST_IS_A_B", "1"}, {"TEST_STEP", "3"}}); });
    expect_contains(message, "-D TEST_IS_A_B=1");
    EXPECT_EQ(message.find("TEST_STEP"), std::string::npos) << message;
    EXPECT_EQ(message.find("undeclared identifier 'TEST_IS_A_B'"), std::string::npos) << message;
}

TEST_F(Program, WarningsAndForgottenDefinesDoNotBuild) {
    const std::string warning = write_file("warning.cl", "#warning look\nkernel void k(global int *out) { out[0] = 1; }\n");
    expect_contains(error_of([&] { programs.kernel("k", warning); }), "look");
    const std::string forgotten = write_file("forgotten.cl", "kernel void k(global int *out) { if (PENCIL_FORGOTTEN) out[0] = 1; }\n");
    expect_contains(error_of([&] { programs.kernel("k", forgotten); }), "PENCIL_FORGOTTEN");
    expect_contains(error_of([&] { kernel("scale", {{"TEST_STEP", "1 -w"}}); }), "holds a blank or quote");
}

TEST_F(Program, KernelFolderOverridesEmbeddedFiles) {
    write_file("self_test.cl", "kernel void self_test_layout(global int *out) { out[0] = 42; }\n");
    setenv("PENCIL_KERNEL_DIR", folder.c_str(), 1);
    Buffer<int> out(device, 1, "out");
    programs.kernel("self_test_layout", "self_test.cl").args(out).run(1, "edited kernel");
    EXPECT_EQ(out.read().at(0), 42);
    expect_contains(error_of([&] { kernel_source("missing.cl"); }), "missing.cl");
}

TEST_F(Program, DumpedSourceBuildsByItself) {
    setenv("PENCIL_DUMP_KERNELS", folder.c_str(), 1);
    kernel("count_visits", {{"TEST_STEP", "5"}});
    unsetenv("PENCIL_DUMP_KERNELS");
    std::vector<std::filesystem::path> dumps;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) dumps.push_back(entry.path());
    ASSERT_EQ(dumps.size(), 1u);
    Buffer<int> counts(device, 3, "counts");
    counts.fill_zero();
    programs.kernel("count_visits", dumps[0].string()).args(counts, 3).run(3, "dumped kernel");
    EXPECT_EQ(counts.read(), std::vector<int>(3, 5));
}

TEST_F(Program, IncludesAreTakenOnceAndKeepTheirLines) {
    write_file("leaf.h", "#pragma once\n#define LEAF 7\n");
    write_file("branch.cl", "// a comment\n#include \"leaf.h\"\nstatic inline int branch(void) { return LEAF; }\n#include \"trunk.cl\"\n");
    write_file("trunk.cl",
               "#include \"branch.cl\"\n#include \"leaf.h\"\n\nkernel void trunk(global int *out) { out[0] = branch() + __LINE__; }\n");
    setenv("PENCIL_KERNEL_DIR", folder.c_str(), 1);
    Buffer<int> out(device, 1, "out");
    programs.kernel("trunk", "trunk.cl").args(out).run(1, "included");
    EXPECT_EQ(out.read().at(0), 7 + 4);
    const std::string source = program_source("trunk.cl");
    EXPECT_EQ(source.find("LEAF 7"), source.rfind("LEAF 7"));
    EXPECT_EQ(source.find("#include \""), std::string::npos);
}

TEST_F(Program, IncludesThatCannotBeResolvedNameFileAndLine) {
    write_file("lost.cl", "\n\n#include \"nowhere.cl\"\n");
    write_file("inner.cl", "#include \"leaf.h\"\n");
    write_file("leaf.h", "#define LEAF 7\n");
    write_file("hidden.cl", "#if 0\n#include \"inner.cl\"\n#endif\n");
    write_file("first.cl",
               "#include \"leaf.h\"\n#if 0\n#include \"inner.cl\"\n#endif\nkernel void k(global int *out) { out[0] = LEAF; }\n");
    setenv("PENCIL_KERNEL_DIR", folder.c_str(), 1);
    expect_contains(error_of([&] { program_source("lost.cl"); }), "lost.cl:3: cannot read the kernel file");
    expect_contains(error_of([&] { program_source("hidden.cl"); }), "inner.cl:1: leaf.h must be included before the #if");
    EXPECT_NE(program_source("first.cl").find("LEAF 7"), std::string::npos);
}

TEST_F(Program, EveryFileResolves) {
    ASSERT_FALSE(embedded_kernels().empty());
    for (const auto& [name, text] : embedded_kernels()) {
        EXPECT_EQ(program_source(name).rfind("#line 1 \"" + name + "\"\n", 0), 0u) << name;
        EXPECT_EQ(program_source(name).find("#include \""), std::string::npos) << name;
    }
    EXPECT_EQ(program_of("project_pencils"), "programs/line.cl");
    EXPECT_EQ(program_of("self_test"), "self_test.cl");
}

}  // namespace
}  // namespace pencil
