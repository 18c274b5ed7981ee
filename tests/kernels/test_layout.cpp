// The structs of kernels/shared have one size on both sides, and the device passes its self-test at every packet width.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <regex>
#include <set>

#include "cl/embedded_kernels.h"
#include "cl/self_test.h"
#include "self_test_layout.h"
#include "shared/bvh.h"
#include "shared/camera.h"
#include "shared/cluster.h"
#include "shared/emitter.h"
#include "shared/geometry.h"
#include "shared/light.h"
#include "shared/material.h"
#include "shared/sky.h"
#include "shared/surface_pencil.h"
#include "shared/texture.h"

namespace pencil {
namespace {

// The rules of the headers ("---- 64 B"), which array strides in buffers depend on.
static_assert(sizeof(float4) == 16 && sizeof(uint) == 4);
static_assert(sizeof(Triangle) == 64 && offsetof(Triangle, plane) == 48);
static_assert(sizeof(Material) == 192 && offsetof(Material, emission) == 16 && offsetof(Material, model) == 32);
static_assert(offsetof(Material, specular) == 48 && offsetof(Material, flags) == 112);
static_assert(sizeof(TextureRow) == 96 && offsetof(TextureRow, kind) == 64);
static_assert(sizeof(Sky) == 64 && offsetof(Sky, width) == 48);
static_assert(sizeof(Hit) == 8);
static_assert(sizeof(LightSample) == 48);
static_assert(sizeof(Camera) == 144 && offsetof(Camera, shift_x) == 64 && offsetof(Camera, width) == 128);
static_assert(sizeof(BvhNode) == 80 && offsetof(BvhNode, child) == 64);
static_assert(sizeof(WideNode) == 224 && offsetof(WideNode, child) == 192);
static_assert(sizeof(WideLeaf) == 240 && offsetof(WideLeaf, corner) == 96);
static_assert(sizeof(Cluster) == 32);
static_assert(sizeof(SurfacePencil) == 192 && offsetof(SurfacePencil, horizon_x) == 48 && offsetof(SurfacePencil, plane) == 176);
static_assert(sizeof(Emitter) == 64 && offsetof(Emitter, triangle) == 48);
static_assert(sizeof(PencilGrid) == 32 && offsetof(PencilGrid, levels) == 16);

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

/// A struct that is added to kernels/shared is compared between host and device like the others.
TEST(Layout, EverySharedStructIsInTheList) {
    std::set<std::string> listed;
#define LISTED_SIZE(T) listed.insert(#T);
#define LISTED_FIELD(T, member)
    PENCIL_LAYOUT(LISTED_SIZE, LISTED_FIELD)
#undef LISTED_SIZE
#undef LISTED_FIELD
    const std::regex definition("typedef struct (\\w+)");
    int found = 0;
    for (const auto& [name, text] : embedded_kernels()) {
        if (name.rfind("shared/", 0) != 0) continue;
        const std::string source = text;
        for (std::sregex_iterator match(source.begin(), source.end(), definition), end; match != end; ++match, ++found)
            EXPECT_EQ(listed.count((*match)[1]), 1u) << (*match)[1] << " of " << name << " is not in self_test_layout.h";
    }
    EXPECT_GE(found, 12);
}

}  // namespace
}  // namespace pencil
