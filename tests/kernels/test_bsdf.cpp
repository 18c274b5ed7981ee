// Every model on the device keeps the laws, and scatters as the path tracer's does, through the door that kernels use.
#include "kernels/scene_row.h"

namespace {

using namespace pencil;
using namespace pencil::test;

struct Case {
    const char* name;
    SceneMaterial material;
    bool front = true;
    double bound = 1e-3;  // of values, relative
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

SceneMaterial with_model(int model, float alpha) {
    SceneMaterial m;
    m.model = model;
    m.alpha = glm::vec2(alpha);
    m.albedo = glm::vec3(0.8F, 0.3F, 0.5F);
    return m;
}

SceneMaterial conductor(float alpha, bool beckmann) {
    SceneMaterial m = with_model(MATERIAL_CONDUCTOR, alpha);
    m.eta = glm::vec3(0.2F, 0.9F, 1.4F);
    m.k = glm::vec3(3.9F, 2.4F, 1.6F);
    m.beckmann = beckmann;
    return m;
}

SceneMaterial mirror() {
    SceneMaterial m = with_model(MATERIAL_CONDUCTOR, 0.0F);
    m.perfect_mirror = true;
    m.specular = glm::vec3(0.9F, 0.5F, 0.2F);
    return m;
}

SceneMaterial plastic(float alpha, bool nonlinear, bool beckmann = false) {
    SceneMaterial m = with_model(MATERIAL_PLASTIC, alpha);
    m.nonlinear = nonlinear;
    m.beckmann = beckmann;
    return m;
}

SceneMaterial dielectric(float alpha, bool beckmann = false) {
    SceneMaterial m = with_model(MATERIAL_DIELECTRIC, alpha);
    m.beckmann = beckmann;
    return m;
}

SceneMaterial thin() {
    SceneMaterial m = dielectric(0.0F);
    m.thin = true;
    m.transmitted = glm::vec3(0.9F, 0.8F, 0.4F);
    return m;
}

SceneMaterial phong() {
    SceneMaterial m = with_model(MATERIAL_PHONG, 0.0F);
    m.exponent = 20.0F;
    m.albedo = glm::vec3(0.5F, 0.2F, 0.4F);
    m.specular = glm::vec3(0.4F, 0.5F, 0.1F);
    return m;
}

/// alpha is the roughness.
SceneMaterial principled(float roughness, float metallic, float spec_trans) {
    SceneMaterial m = with_model(MATERIAL_PRINCIPLED, roughness);
    m.principled.metallic = metallic;
    m.principled.spec_trans = spec_trans;
    return m;
}

/// Of one colour, since base_factor is one number.
SceneMaterial grey_matte() {
    SceneMaterial m = with_model(MATERIAL_ROUGH_DIFFUSE, 0.6F);
    m.albedo = glm::vec3(0.7F);
    return m;
}

SceneMaterial cloth() {
    SceneMaterial m = principled(0.7F, 0.2F, 0.0F);
    m.albedo = glm::vec3(0.6F);
    m.principled.sheen = 0.8F;
    m.principled.flatness = 0.5F;
    m.principled.spec_tint = 0.4F;
    return m;
}

SceneMaterial lacquer() {
    SceneMaterial m = principled(0.6F, 0.3F, 0.0F);
    m.principled.clearcoat = 1.0F;
    m.principled.clearcoat_gloss = 0.1F;
    return m;
}

// The half floats and 33 angles of the varnish's table, near grazing.
constexpr double varnish = 1.5e-2;

// Walter's rational function for the masking of Beckmann's facets.
constexpr double masking = 8e-3;

const std::vector<Case> rough{{"Conductor", conductor(0.3F, false)},
                              {"ConductorBeckmann", conductor(0.25F, true), true, masking},
                              {"Plastic", plastic(0.3F, false), true, varnish},
                              {"PlasticNonlinearBeckmann", plastic(0.2F, true, true), true, varnish},
                              {"Dielectric", dielectric(0.3F)},
                              {"DielectricBeckmann", dielectric(0.3F, true), true, masking},
                              {"DielectricFromInside", dielectric(0.3F), false},
                              {"Phong", phong()},
                              {"PrincipledMetal", principled(0.6F, 1.0F, 0.0F)},
                              {"PrincipledGlass", principled(0.6F, 0.0F, 1.0F)},
                              {"PrincipledGlassFromInside", principled(0.6F, 0.0F, 1.0F), false},
                              {"PrincipledMixed", principled(0.5F, 0.4F, 0.5F)},
                              {"PrincipledCloth", cloth()},
                              {"PrincipledLacquer", lacquer()}};

const std::vector<Case> smooth{{"Mirror", mirror()},
                               {"SmoothConductor", conductor(0.0F, false)},
                               {"SmoothPlastic", plastic(0.0F, false)},
                               {"SmoothDielectric", dielectric(0.0F)},
                               {"SmoothDielectricFromInside", dielectric(0.0F), false},
                               {"Thin", thin()},
                               {"ThinFromTheBack", thin(), false}};

const std::vector<Case> even{{"Diffuse", with_model(MATERIAL_DIFFUSE, 0.0F)},
                             {"RoughDiffuse", grey_matte(), true, 2e-3},
                             {"SmoothPlastic", plastic(0.0F, true), true, varnish}};

std::string name_of(const testing::TestParamInfo<Case>& tested) { return tested.param.name; }

class Bsdf : public testing::TestWithParam<Case> {
protected:
    SceneRow row{GetParam().material, GetParam().front};
    DeviceBsdf model{"bsdf", row.row()};
};
class RoughBsdf : public Bsdf {};
class SmoothBsdf : public Bsdf {};
class EvenBsdf : public Bsdf {};

TEST_P(RoughBsdf, KeepsTheLaws) {
    expect_reference(model, row.scattering(), GetParam().bound);
    expect_base(model, row.scattering(), 2e-2);
    expect_samples_follow_pdf(model);
    expect_samples_give_lobes(model);
}
INSTANTIATE_TEST_SUITE_P(Models, RoughBsdf, testing::ValuesIn(rough), name_of);

TEST_P(EvenBsdf, IsAllBase) {
    expect_reference(model, row.scattering(), GetParam().bound);
    expect_base(model, row.scattering(), 2e-2);
}
INSTANTIATE_TEST_SUITE_P(Models, EvenBsdf, testing::ValuesIn(even), name_of);

/// What goes above the surface and below it, and where.
struct Sides {
    dvec3 above{0.0}, below{0.0}, up{0.0}, down{0.0};
    void add(const dvec3& omega_i, const dvec3& weight) {
        (omega_i.z > 0.0 ? above : below) += weight;
        (omega_i.z > 0.0 ? up : down) = omega_i;
    }
};

/// Lobes of no width: the same directions, and as much light in each.
TEST_P(SmoothBsdf, SendsLightWhereThePathTracerDoes) {
    const int count = 2000;
    for (const double z : {1.0, 0.8, 0.3}) {
        const dvec3 o = ref::as_float(ref::direction_at(z, 1.0));
        std::vector<dvec3> u;
        for (int k = 0; k < count; ++k) u.emplace_back(0.3, 0.6, (k + 0.5) / count);
        Sides got, expected;
        for (const DeviceBsdf::Sample& s : model.sample(o, u)) {
            EXPECT_EQ(s.pdf, 0.0);
            if (s.exists()) got.add(s.omega_i, s.weight / static_cast<double>(count));
        }
        for (const dvec3& v : u) {
            const BsdfSample s = pencil::sample(row.reference(), glm::vec3(o), glm::dvec2(v), v.z);
            if (s.pdf > 0.0F && s.delta) expected.add(s.omega_i, dvec3(s.weight) / static_cast<double>(count));
        }
        EXPECT_LT(glm::distance(got.up, expected.up), 1e-5) << z;
        EXPECT_LT(glm::distance(got.down, expected.down), 1e-5) << z;
        EXPECT_LT(glm::distance(got.above, expected.above), 2e-3) << z;
        EXPECT_LT(glm::distance(got.below, expected.below), 2e-3) << z;
        for (const DeviceBsdf::Value& v : model.evaluate({o}, {dvec3(-o.x, -o.y, o.z)})) {
            EXPECT_EQ(v.lobes, dvec3(0.0));
            EXPECT_EQ(v.pdf, 0.0);
        }
    }
}
INSTANTIATE_TEST_SUITE_P(Models, SmoothBsdf, testing::ValuesIn(smooth), name_of);

/// Nothing is made: all colours white. The principled base and boundary may reflect more together, by its definition.
TEST(BsdfFurnace, NoMoreThanCameIn) {
    SceneMaterial shiny = phong();
    shiny.albedo = shiny.specular = glm::vec3(0.5F);
    SceneMaterial metal = principled(0.6F, 1.0F, 0.0F), glass = principled(0.6F, 0.0F, 1.0F);
    SceneMaterial white_plastic = plastic(0.3F, true);
    SceneMaterial matte = with_model(MATERIAL_ROUGH_DIFFUSE, 0.6F);
    for (SceneMaterial* m : {&metal, &glass, &white_plastic, &matte}) m->albedo = glm::vec3(1.0F);
    for (const SceneMaterial& m : {conductor(0.4F, false), conductor(0.4F, true), dielectric(0.4F), dielectric(0.4F, true), shiny, metal,
                                   glass, white_plastic, matte})
        for (const bool front : {true, false}) {
            const SceneRow row(m, front);
            const bool turns = m.model == MATERIAL_DIELECTRIC || m.principled.spec_trans > 0.0F;
            if (!front && !turns) continue;
            DeviceBsdf model("bsdf", row.row());
            SCOPED_TRACE("model " + std::to_string(m.model) + (front ? "" : " from inside"));
            expect_white_furnace(model, turns ? static_cast<double>(front ? m.eta.x : 1.0F / m.eta.x) : 1.0);
        }
}

TEST(BsdfOfDiffuse, IsItsAlbedoToTheBit) {
    const SceneRow row(with_model(MATERIAL_DIFFUSE, 0.0F), true);
    DeviceBsdf model("bsdf", row.row());
    for (const DeviceBsdf::Even& e : model.even({{0, 0, 1}, ref::direction_at(0.3, 1.0)})) {
        EXPECT_EQ(e.base, xyz(row.row().row.albedo));
        EXPECT_EQ(e.share, dvec3(0.0));
    }
}

}  // namespace
