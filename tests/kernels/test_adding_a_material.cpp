// The model that docs/adding_a_material.md adds keeps the laws of all models, and the page shows the code that is tested.
#include <fstream>
#include <sstream>

#include "kernels/brdf_laws.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr const char* model_file = PENCIL_SOURCE_DIR "/tests/kernels/adding_a_material.cl";

Material dusty_row() {
    Material m{};
    m.albedo = float4(1.0F, 0.3F, 0.7F, 0.0F);
    return m;
}

class AddingAMaterial : public testing::Test {
protected:
    DeviceBrdf model{"seeliger", dusty_row(), PENCIL_SOURCE_DIR "/tests/kernels/adding_a_material_laws.cl"};
};

TEST_F(AddingAMaterial, IsLommelSeeliger) { expect_reference(model, ref::lommel_seeliger); }
TEST_F(AddingAMaterial, IsReciprocal) { expect_reciprocal(model); }
TEST_F(AddingAMaterial, IsDarkBelowTheHorizon) { expect_dark_below_horizon(model); }
TEST_F(AddingAMaterial, WhiteFurnace) { expect_white_furnace(model); }
TEST_F(AddingAMaterial, SamplesFollowTheirDensity) { expect_samples_follow_pdf(model); }
TEST_F(AddingAMaterial, SamplesGiveTheAlbedo) { expect_samples_give_albedo(model); }

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
