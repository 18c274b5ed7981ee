// The model that docs/adding_a_material.md adds keeps the laws of all models, and the page shows the code that is tested.
#include <fstream>
#include <sstream>

#include "kernels/bsdf_laws.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr const char* model_file = PENCIL_SOURCE_DIR "/tests/kernels/adding_a_material.cl";

BsdfRow dusty_row() {
    BsdfRow made;
    made.row.albedo = float4(1.0F, 0.3F, 0.7F, 0.0F);
    return made;
}

class AddingAMaterial : public testing::Test {
protected:
    DeviceBsdf model{"seeliger", dusty_row(), PENCIL_SOURCE_DIR "/tests/kernels/adding_a_material_laws.cl"};
};

TEST_F(AddingAMaterial, IsLommelSeeliger) {
    expect_reference(
        model,
        [](const dvec3& o, const dvec3& i) {
            return ref::lommel_seeliger({1.0, 0.3, 0.7}, o, i) * i.z;
        },
        1e-5);
}
TEST_F(AddingAMaterial, IsReciprocal) { expect_reciprocal(model); }
TEST_F(AddingAMaterial, WhiteFurnace) { expect_white_furnace(model, 1.0); }
TEST_F(AddingAMaterial, SamplesFollowTheirDensity) { expect_samples_follow_pdf(model); }
TEST_F(AddingAMaterial, SamplesGiveTheLobes) { expect_samples_give_lobes(model); }

std::string text_of(const std::string& path) {
    std::ifstream in(path);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

TEST(AddingAMaterialPage, ShowsWhatIsTested) {
    const std::string code = text_of(model_file);
    ASSERT_FALSE(code.empty());
    EXPECT_NE(text_of(PENCIL_SOURCE_DIR "/docs/adding_a_material.md").find("```c\n" + code + "```"), std::string::npos)
        << "docs/adding_a_material.md and tests/kernels/adding_a_material.cl differ";
}

}  // namespace
