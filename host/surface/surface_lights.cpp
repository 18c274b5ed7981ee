#include "surface/surface_lights.h"

#include <algorithm>

#include "surface/surface_pass.h"
#include "util/constants.h"

namespace pencil {

namespace {

/// `fewer`: of so many samples one is drawn.
LobeLights lobe_lights(const RenderContext& context, const std::shared_ptr<Device>& device, const std::vector<LightSample>& samples,
                       double fewer) {
    const auto is_sky = [](const LightSample& s) { return s.position.w == LIGHT_INFINITE && s.normal.w > 0; };
    const auto sky = static_cast<double>(std::count_if(samples.begin(), samples.end(), is_sky));
    return {Buffer<float>(device, near_areas(context.flat, samples, fewer), "near areas of emitters"), static_cast<float>(sky / fewer)};
}

/// About, rgb together [W]: of lamps that are near.
double power_of(const std::vector<LightSample>& samples) {
    double power = 0;
    for (const LightSample& s : samples) {
        const double emission = static_cast<double>(s.emission.x) + static_cast<double>(s.emission.y) + static_cast<double>(s.emission.z);
        power += s.position.w == LIGHT_INFINITE ? 0 : s.position.w == LIGHT_AREA ? pi * emission : 4 * pi * emission;
    }
    return power;
}

}  // namespace

SurfaceLights surface_lights(const RenderContext& context, const std::shared_ptr<Device>& device, const SurfacePass& pass,
                             const std::vector<LightSample>& of_film, std::uint64_t seed) {
    const std::vector<LightSample> samples = sample_lights(context.scene, context.flat, context.forms, pass.texel_light_samples, seed);
    const auto near = [&](const std::vector<LightSample>& s) {
        return Buffer<float>(device, near_areas(context.flat, s), "near areas of emitters");
    };
    const auto of_all = static_cast<double>(samples.size());
    return {samples.empty() ? LightSet() : LightSet(device, samples, 0),
            near(of_film),
            near(samples),
            lobe_lights(context, device, of_film, fewer_lights(pass, static_cast<int>(of_film.size()))),
            lobe_lights(context, device, samples, of_all / pass.world.light_draws),
            lobe_lights(context, device, samples, of_all / chain_draws),
            small_lights(context, samples),
            power_of(samples)};
}

}  // namespace pencil
