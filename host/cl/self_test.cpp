// The host's side of kernels/self_test.cl: inputs, expected answers and how far a device may be off.
#include "cl/self_test.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>

#include "self_test_layout.h"
#include "shared/bvh.h"
#include "shared/camera.h"
#include "shared/cluster.h"
#include "shared/geometry.h"
#include "shared/light.h"
#include "shared/material.h"
#include "shared/surface_pencil.h"

namespace pencil {
namespace {

Launch build_for_groups(ProgramCache& programs, const std::string& name, int group) {
    return programs.kernel(name, "self_test.cl", {{"SELF_TEST_GROUP", std::to_string(group)}});
}

// Work-items that add up together: 64, or fewer where the device allows the kernel no more.
int reduction_group(ProgramCache& programs) {
    int group = 64;
    while (group > 1 && build_for_groups(programs, "self_test_reduction", group).max_group() < static_cast<std::size_t>(group)) group /= 2;
    return group;
}

Launch self_test_kernel(ProgramCache& programs, const std::string& name) {
    return build_for_groups(programs, name, reduction_group(programs));
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

void note_difference(std::string& trouble, const std::string& what, const std::string& expected, const std::string& found) {
    trouble += (trouble.empty() ? "" : "; ") + what + ": expected " + expected + ", device says " + found;
}

std::string check_layout(ProgramCache& programs) {
    struct Entry {
        const char* name;
        std::size_t value;
    };
#define LAYOUT_SIZE(T) {"sizeof(" #T ")", sizeof(T)},
#define LAYOUT_FIELD(T, member) {"offsetof(" #T ", " #member ")", offsetof(T, member)},
    const std::vector<Entry> expected = {PENCIL_LAYOUT(LAYOUT_SIZE, LAYOUT_FIELD)};
#undef LAYOUT_SIZE
#undef LAYOUT_FIELD
    Buffer<std::uint32_t> out(programs.device(), expected.size(), "self-test layout");
    self_test_kernel(programs, "self_test_layout").args(out).run(1, "self-test layout");
    const std::vector<std::uint32_t> found = out.read();
    std::string trouble;
    for (std::size_t i = 0; i < expected.size(); ++i)
        if (found[i] != expected[i].value)
            note_difference(trouble, expected[i].name, std::to_string(expected[i].value), std::to_string(found[i]));
    return trouble;
}

std::string check_floats(ProgramCache& programs) {
    // OpenCL C 1.2, table 7.4.1: bounds in ulp of the full profile.
    struct Entry {
        const char* name;
        double value;
        double ulps;
    };
    const Entry expected[] = {{"isnan(NaN)", 1, 0},
                              {"isfinite(NaN)", 0, 0},
                              {"isinf(1/0)", 1, 0},
                              {"isfinite(1/0)", 0, 0},
                              {"fmax(NaN, 0.5)", 0.5, 0},
                              {"fmin(0.5, NaN)", 0.5, 0},
                              {"NaN == NaN", 0, 0},
                              {"NaN < 1 or NaN >= 1", 0, 0},
                              {"1/infinity", 0, 0},
                              {"sign of 1/-0, if infinite", -1, 0},
                              {"copysign(1, -0)", -1, 0},
                              {"exponent bits of NaN", 1, 0},
                              {"floor(-2.5)", -3, 0},
                              {"rint(-2.5)", -2, 0},
                              {"(int)-2.5", -2, 0},
                              {"1/3", 1.0 / 3.0, 2.5},
                              {"sqrt(3)", std::sqrt(3.0), 3},
                              {"rsqrt(3)", 1.0 / std::sqrt(3.0), 2},
                              {"exp(-2.5)", std::exp(-2.5), 3},
                              {"pow(3, 0.5)", std::sqrt(3.0), 16}};
    const std::size_t count = std::size(expected);
    const Buffer<float> in(programs.device(), std::vector<float>{0.0f, 1.0f, 3.0f, 0.5f, -2.5f}, "self-test input");
    Buffer<float> out(programs.device(), count, "self-test floats");
    self_test_kernel(programs, "self_test_floats").args(in, out).run(1, "self-test floats");
    const std::vector<float> found = out.read();
    std::string trouble;
    for (std::size_t i = 0; i < count; ++i) {
        // One ulp of a float is at most 2^-23 of it; half of one more is the rounding of the expected value itself.
        const double bound = expected[i].ulps == 0 ? 0 : (expected[i].ulps + 0.5) * std::ldexp(std::fabs(expected[i].value), -23);
        if (!(std::fabs(found[i] - expected[i].value) <= bound))
            note_difference(trouble, expected[i].name, number(expected[i].value), number(found[i]));
    }
    return trouble;
}

// (1 + 2^-12)^2 - (1 + 2^-11) is 2^-24 with one rounding and 0 with two. Only fma() must be exact: whether the compiler contracts, and
// obeys the pragma, differs between devices and is reported.
std::string check_contraction(ProgramCache& programs, std::string& found_out) {
    const float a = 1.0f + 0x1p-12f;
    const Buffer<float> in(programs.device(), std::vector<float>{a, a, -(1.0f + 0x1p-11f)}, "self-test input");
    Buffer<float> out(programs.device(), 3, "self-test contraction");
    self_test_kernel(programs, "self_test_contraction").args(in, out).run(1, "self-test contraction");
    const std::vector<float> found = out.read();
    found_out = std::string("a*b+c is ") + (found[0] == 0 ? "rounded twice" : "contracted to fma") + " by default, " +
                (found[2] == 0 ? "rounded twice" : "contracted all the same") + " under FP_CONTRACT OFF";
    std::string trouble;
    if (found[1] != 0x1p-24f) note_difference(trouble, "fma", number(0x1p-24), number(found[1]));
    return trouble;
}

std::string check_integers(ProgramCache& programs) {
    const std::uint32_t a = 0x9e3779b9u, b = 7;
    const std::int32_t c = -13;
    const std::uint64_t wide = std::uint64_t{a} * a;
    const std::pair<const char*, std::uint32_t> expected[] = {
        {"low product", static_cast<std::uint32_t>(wide)},
        {"mul_hi", static_cast<std::uint32_t>(wide >> 32)},
        {"64-bit product", static_cast<std::uint32_t>(wide >> 32)},
        {"rotate", (a << b) | (a >> (32 - b))},
        {"popcount", static_cast<std::uint32_t>(__builtin_popcount(a))},
        {"clz", static_cast<std::uint32_t>(__builtin_clz(b))},
        {"-13 >> 1", static_cast<std::uint32_t>(-7)},
        {"-13 % 7", static_cast<std::uint32_t>(c % static_cast<std::int32_t>(b))},
        {"-13 / 7", static_cast<std::uint32_t>(c / static_cast<std::int32_t>(b))},
        {"64-bit wrap", static_cast<std::uint32_t>((wide * 0x5851f42d4c957f2dull) >> 40)}};
    const Buffer<std::uint32_t> in(programs.device(), std::vector<std::uint32_t>{a, b, static_cast<std::uint32_t>(c)}, "self-test input");
    Buffer<std::uint32_t> out(programs.device(), std::size(expected), "self-test integers");
    self_test_kernel(programs, "self_test_integers").args(in, out).run(1, "self-test integers");
    const std::vector<std::uint32_t> found = out.read();
    std::string trouble;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i] != expected[i].second)
            note_difference(trouble, expected[i].first, std::to_string(expected[i].second), std::to_string(found[i]));
    return trouble;
}

std::string check_packets(ProgramCache& programs) {
    const int width = programs.device()->packet_width(), packets = 37, count = packets * width;  // not a multiple of any local size
    std::vector<float> input;
    input.reserve(static_cast<std::size_t>(count));
    // Whole packets without a positive value, packets with one, and NaN, which is never above zero.
    for (int i = 0; i < count; ++i) input.push_back((i / width) % 3 == 0 ? -1.5f : static_cast<float>(i % 5) - 2.0f);
    input.back() = std::numeric_limits<float>::quiet_NaN();
    const Buffer<float> in(programs.device(), input, "self-test input");
    Buffer<float> values(programs.device(), count, "self-test packets");
    Buffer<int> lanes(programs.device(), count, "self-test lanes"), any(programs.device(), packets, "self-test any");
    Buffer<int> packed(programs.device(), count, "self-test packed lanes");
    self_test_kernel(programs, "self_test_packets").args(in, count, values, lanes, any, packed).run(packets, "self-test packets");
    const std::vector<float> found = values.read();
    const std::vector<int> found_lanes = lanes.read(), found_any = any.read(), found_packed = packed.read();
    std::string trouble;
    for (int i = 0; i < count && trouble.empty(); ++i) {
        const float expected = input[i] > 0 ? input[i] * input[i] : -1.0f;
        if (found[i] != expected) note_difference(trouble, "value " + std::to_string(i), number(expected), number(found[i]));
        if (found_lanes[i] != i % width)
            note_difference(trouble, "lane of " + std::to_string(i), std::to_string(i % width), std::to_string(found_lanes[i]));
    }
    for (int p = 0; p < packets && trouble.empty(); ++p) {
        std::vector<int> expected;
        for (int l = 0; l < width; ++l)
            if (input[p * width + l] > 0) expected.push_back(l);
        const int any_expected = expected.empty() ? 0 : 1;
        if (found_any[p] != any_expected)
            note_difference(trouble, "any of packet " + std::to_string(p), std::to_string(any_expected), std::to_string(found_any[p]));
        expected.resize(width, -1);
        if (!std::equal(expected.begin(), expected.end(), found_packed.begin() + p * width))
            note_difference(trouble, "lanes above zero of packet " + std::to_string(p), "them in order", "others");
    }
    return trouble;
}

// The order of additions is given, so the sums must agree to the last bit.
std::string check_reduction(ProgramCache& programs) {
    const int groups = 33, size = reduction_group(programs);
    std::vector<float> input;
    std::uint32_t state = 1;
    for (int i = 0; i < groups * size; ++i) {
        state = state * 1664525u + 1013904223u;
        input.push_back(std::ldexp(static_cast<float>(state >> 8), static_cast<int>(state % 32) - 40));
    }
    const Buffer<float> in(programs.device(), input, "self-test input");
    Buffer<float> out(programs.device(), groups, "self-test sums");
    Launch launch = self_test_kernel(programs, "self_test_reduction");
    std::string trouble;
    for (int repeat = 0; repeat < 2; ++repeat) {
        out.fill_zero();
        launch.args(in, out).run(input.size(), "self-test reduction", size);
        const std::vector<float> found = out.read();
        for (int g = 0; g < groups && trouble.empty(); ++g) {
            std::vector<float> partial(input.begin() + g * size, input.begin() + (g + 1) * size);
            for (int distance = size / 2; distance > 0; distance /= 2)
                for (int i = 0; i < distance; ++i) partial[i] += partial[i + distance];
            if (found[g] != partial[0]) note_difference(trouble, "sum " + std::to_string(g), number(partial[0]), number(found[g]));
        }
    }
    return trouble;
}

template <typename Check>
SelfTestResult run_check(const std::string& name, Check&& check) {
    SelfTestResult result;
    result.name = name;
    try {
        const std::string trouble = check(result.detail);
        result.passed = trouble.empty();
        if (!result.passed) result.detail = trouble;
    } catch (const std::exception& error) {
        result.detail = error.what();
    }
    return result;
}

}  // namespace

std::vector<SelfTestResult> self_test(ProgramCache& programs) {
    const SelfTestResult build = run_check("kernel build", [&](std::string&) {
        self_test_kernel(programs, "self_test_layout");
        return std::string();
    });
    if (!build.passed) return {build};
    return {build,
            run_check("struct layout", [&](std::string&) { return check_layout(programs); }),
            run_check("float arithmetic", [&](std::string&) { return check_floats(programs); }),
            run_check("fused multiply-add", [&](std::string& found_out) { return check_contraction(programs, found_out); }),
            run_check("integer arithmetic", [&](std::string&) { return check_integers(programs); }),
            run_check("packets", [&](std::string&) { return check_packets(programs); }),
            run_check("ordered reduction", [&](std::string&) { return check_reduction(programs); })};
}

}  // namespace pencil
