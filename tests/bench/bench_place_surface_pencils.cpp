// Surface pencils on every fourth of the texels' surfels.
#include "bench/surface_bench.h"
#include "surface/place_surface_pencils.h"

namespace pencil::bench {
namespace {

void bench_place_surface_pencils(benchmark::State& state) {
    Workbench& bench = workbench();
    const HostSurfels host(bench.texel_surfels);
    ChosenSurfels chosen;
    for (int i = 0; i < host.count / 4; ++i)
        chosen.add(static_cast<int>(i * 7919LL % host.count), static_cast<uint>(i), {0.1F, 0.2F, 0.3F}, 0.1F);
    const int count = static_cast<int>(chosen.surfels.size());
    SurfacePencils pencils(device(), count, 4);
    std::vector<SurfacePencil> native_pencils(chosen.surfels.size());
    compare(
        state,
        {std::to_string(count) + " pencils",
         static_cast<double>(count),
         static_cast<double>(count) * (13 * 4 + sizeof(SurfacePencil)),
         {"place surface pencils"}},
        [&] {
            pencils.count = 0;
            place_surface_pencils(bench.kernels, bench.texel_surfels, chosen, pencils);
        },
        [&] {
            native::place_surface_pencils(host.view(), chosen.surfels.data(), chosen.keys.data(), chosen.views.data(), count, 0,
                                          native_pencils.data());
        },
        [&] {
            std::vector<float> got, expected;
            const auto list = [](const std::vector<SurfacePencil>& from, std::vector<float>& to) {
                for (const SurfacePencil& p : from)
                    for (int c = 0; c < 3; ++c) to.insert(to.end(), {p.position[c], p.normal[c], p.facing[c]});
            };
            list(pencils.data.read(), got);
            list(native_pencils, expected);
            return differences(got, expected, 1e-5, 0);
        });
}
BENCHMARK(bench_place_surface_pencils)->Name("place_surface_pencils")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
