// The diffuse model, called by its name and through the door that kernels use, and the forms of scattering K.
#include "kernels/brdf_laws.h"

namespace {

using namespace pencil;
using namespace pencil::test;

Material diffuse_row() {
    Material m{};
    m.albedo = float4(0.8F, 0.25F, 1.0F, 1.0F);
    m.model = MATERIAL_DIFFUSE;
    return m;
}

/// "diffuse" and "brdf": the model, and what a row that names it is dispatched to.
class Brdf : public testing::TestWithParam<const char*> {
protected:
    DeviceBrdf model{GetParam(), diffuse_row()};
};

TEST_P(Brdf, IsLambert) { expect_reference(model, ref::lambert); }
TEST_P(Brdf, IsReciprocal) { expect_reciprocal(model); }
TEST_P(Brdf, IsDarkBelowTheHorizon) { expect_dark_below_horizon(model); }
TEST_P(Brdf, WhiteFurnace) { expect_white_furnace(model); }
TEST_P(Brdf, SamplesFollowTheirDensity) { expect_samples_follow_pdf(model); }
TEST_P(Brdf, SamplesGiveTheAlbedo) { expect_samples_give_albedo(model); }

TEST_P(Brdf, AlbedoIsTheRowsToTheBit) {
    for (const dvec3& albedo : model.albedo({{0, 0, 1}, ref::direction_at(0.3, 1.0), ref::direction_at(0.0, 2.0)}))
        EXPECT_EQ(albedo, xyz(diffuse_row().albedo));
}

INSTANTIATE_TEST_SUITE_P(Diffuse, Brdf, testing::Values("diffuse", "brdf"), [](const auto& model) { return std::string(model.param); });

/// All forms are albedo E / pi, and each keeps its own order of multiplications: images depend on it to the last bit.
TEST(BrdfForms, RoundAsTheyAlwaysDid) {
    DeviceBrdf model("brdf", diffuse_row());
    Random random(7);
    std::vector<float> albedo, irradiance;
    for (int i = 0; i < 640; ++i) {
        albedo.push_back(static_cast<float>(random.uniform()));
        irradiance.push_back(static_cast<float>(10.0 * random.uniform()));
    }
    const int count = static_cast<int>(albedo.size());
    Buffer<float> scalar(device(), albedo.size(), "scalar"), packet(device(), albedo.size(), "packet"),
        radiosity(device(), albedo.size(), "radiosity");
    model.kernel("brdf_forms")
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
