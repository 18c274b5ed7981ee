// The forms of reflection of irradiance.
#include "kernels/kernel_test.h"
#include "reference/brdf_ref.h"
#include "reference/tolerances.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// All forms are albedo E / pi, and each keeps its own order of multiplications: images depend on it to the last bit.
TEST(BrdfForms, RoundAsTheyAlwaysDid) {
    ProgramCache programs(device());
    Random random(7);
    std::vector<float> albedo, irradiance;
    for (int i = 0; i < 640; ++i) {
        albedo.push_back(static_cast<float>(random.uniform()));
        irradiance.push_back(static_cast<float>(10.0 * random.uniform()));
    }
    const int count = static_cast<int>(albedo.size());
    Buffer<float> scalar(device(), albedo.size(), "scalar"), packet(device(), albedo.size(), "packet"),
        radiosity(device(), albedo.size(), "radiosity");
    programs.kernel("brdf_forms", PENCIL_SOURCE_DIR "/tests/kernels/test_brdf_forms.cl")
        .args(Buffer<float>(device(), albedo, "albedo"), Buffer<float>(device(), irradiance, "irradiance"), count, scalar, packet,
              radiosity)
        .run(albedo.size() / static_cast<std::size_t>(device()->packet_width()), "forms");
    const std::vector<float> scalars = scalar.read(), packets = packet.read(), radiosities = radiosity.read();
    const float inverse_pi = 0.318309886183790671538F;
    for (std::size_t i = 0; i < albedo.size(); ++i) {
        const volatile float product = albedo[i] * irradiance[i], scaled = inverse_pi * albedo[i];
        EXPECT_EQ(scalars[i], product * inverse_pi);
        EXPECT_EQ(packets[i], irradiance[i] * scaled);
        EXPECT_EQ(radiosities[i], product);
        EXPECT_NEAR(scalars[i], static_cast<double>(albedo[i]) * irradiance[i] / ref::brdf_pi, tolerance::few_operations * irradiance[i]);
    }
}

}  // namespace
