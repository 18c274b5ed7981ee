// Emission reaches surfels seen from the front of an emitter and no others; with `carried_only` just those whose light the maps carry.
#include "film/emit_surfels.h"
#include "kernels/kernel_test.h"

namespace {

using namespace pencil;
using namespace pencil::test;

TEST(EmitSurfels, FrontOfEmittersOnly) {
    Random random(81);
    const TestScene scene = soup_scene(82, 60);
    Kernels kernels = make_kernels();
    const DeviceScene on_device(device(), scene.flat);
    for (const int limit : {1, 37, 1000}) {
        for (const bool carried_only : {false, true}) {
            const Surfels surfels = gathered(kernels, on_device, random_centres(random, 4), 16, limit);
            const HostSurfels host(surfels);
            std::vector<float> before(host.capacity * 3);
            for (float& value : before) value = static_cast<float>(random.uniform());
            Buffer<float> radiance(device(), before, "radiance");
            emit_surfels(kernels, on_device, surfels, carried_only, radiance);
            const std::vector<float> after = radiance.read();
            for (int i = 0; i < static_cast<int>(host.capacity); ++i) {
                dvec3 expected = rgb_at(before, host.capacity, i);
                const int material = i < host.count ? host.material(i) : PENCIL_NO_MATERIAL;
                if (material >= 0 && material != PENCIL_NO_MATERIAL) {
                    const Material& m = scene.flat.materials[static_cast<std::size_t>(material)];
                    if (!carried_only || m.emission.w > 0.5F) expected += xyz(m.emission);
                }
                expect_close(rgb_at(after, host.capacity, i), expected, 1e-6, "surfel " + std::to_string(i));
            }
        }
    }
}

}  // namespace
