// Devices that share a render: its image is that of one alone, bit by bit where they round alike.
#include "render/render.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"

namespace pencil::test {
namespace {

RenderOptions few_pencils() {
    RenderOptions options;
    options.width = 64;
    options.height = 48;
    options.target_error = 1e-3;
    return options;
}

RenderResult render_on(const Scene& scene, const std::shared_ptr<Device>& first, const std::vector<std::shared_ptr<Device>>& helpers) {
    RenderCare care;
    care.helpers = helpers;
    return render(scene, few_pencils(), first, {}, care);
}

void expect_equal(const RenderResult& a, const RenderResult& b) {
    ASSERT_EQ(a.layers.size(), b.layers.size());
    for (std::size_t i = 0; i < a.layers.size(); ++i) EXPECT_TRUE(a.layers[i].pixels == b.layers[i].pixels) << a.layers[i].name;
}

std::uint64_t pencils_of_helpers(const RenderResult& result) {
    std::uint64_t all = 0;
    for (const auto& [name, pencils] : result.stats.device_pencils) all += pencils;
    return all;
}

TEST(SeveralDevices, GiveTheImageOfOne) {
    for (const Scene& scene : {room_of_everything(), two_rooms(0.1, true)}) {
        const RenderResult alone = render_on(scene, device(), {});
        EXPECT_TRUE(alone.stats.device_pencils.empty());
        const RenderResult shared = render_on(scene, device(), {Device::open(""), Device::open("")});
        expect_equal(alone, shared);
        EXPECT_EQ(pencils_of_helpers(shared), shared.stats.film_pencils);
    }
}

}  // namespace
}  // namespace pencil::test
