// The structs of kernels/shared have one size on both sides, and the device passes its self-test at every packet width.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>

#include "cl/self_test.h"

// Order matters: these headers rely on the first one.
// clang-format off
#include "shared/types.h"
#include "shared/geometry.h"
#include "shared/light.h"
#include "shared/camera.h"
#include "shared/surface_pencil.h"
// clang-format on

namespace pencil {
namespace {

// The rules of the headers ("---- 64 B"), which array strides in buffers depend on.
static_assert(sizeof(float4) == 16 && sizeof(uint) == 4);
static_assert(sizeof(Triangle) == 64 && offsetof(Triangle, plane) == 48);
static_assert(sizeof(Material) == 32 && offsetof(Material, emission) == 16);
static_assert(sizeof(Hit) == 8);
static_assert(sizeof(LightSample) == 48);
static_assert(sizeof(SurfacePencil) == 192 && offsetof(SurfacePencil, horizon_x) == 48 && offsetof(SurfacePencil, plane) == 176);
static_assert(sizeof(PencilGrid) == 32 && offsetof(PencilGrid, size_x) == 16);
static_assert(sizeof(Camera) == 80 && offsetof(Camera, width) == 64);

class SelfTest : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        if (*GetParam()) setenv("PENCIL_WIDTH", GetParam(), 1);
    }
    void TearDown() override { unsetenv("PENCIL_WIDTH"); }
};

TEST_P(SelfTest, Passes) {
    ProgramCache programs(Device::open(""));
    const std::vector<SelfTestResult> results = self_test(programs);
    EXPECT_EQ(results.size(), 7u);
    for (const SelfTestResult& result : results) EXPECT_TRUE(result.passed) << result.name << ": " << result.detail;
}

INSTANTIATE_TEST_SUITE_P(Width, SelfTest, testing::Values("", "1", "4", "8", "16"),
                         [](const auto& width) { return std::string(*width.param ? width.param : "OfTheDevice"); });

}  // namespace
}  // namespace pencil
