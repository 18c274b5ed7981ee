// How far the film pencils of a lattice may be used.
#include "bench/surface_bench.h"
#include "surface/limit_reuse.h"

namespace pencil::bench {
namespace {

void bench_limit_reuse(benchmark::State& state) {
    LatticeBench& bench = lattice_bench();
    const native::LatticeView view = bench.view();
    const double pixels = static_cast<double>(view.width) * view.height;
    std::vector<float> reaches(bench.host_pencils.size());
    compare(
        state, {product(view.width * view.height, "pixels", bench.pencils.count, "pencils"), pixels, 4.0 * pixels, {"limit reuse"}},
        [&] { limit_reuse(workbench().kernels, bench.pencils, bench.at, LatticeBench::finest, 0, view.width, view.height); },
        [&] { native::limit_reuse(view, LatticeBench::finest, reaches.data()); },
        [&] {
            std::vector<float> got;
            for (const SurfacePencil& p : bench.pencils.data.read(0, reaches.size())) got.push_back(p.facing.w);
            return differences(got, reaches, 1e-3, 1e-3);
        });
}
BENCHMARK(bench_limit_reuse)->Name("limit_reuse")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pencil::bench
