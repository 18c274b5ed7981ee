// The data of the benchmarks of the surface method: a world set and film pencils of the workbench's scene, made by the product's own
// stages, with copies on the host for the native loops.
#pragma once

#include "bench/native/surface.h"
#include "bench/workbench.h"
#include "surface/film_lattice.h"
#include "surface/world_set.h"

namespace pencil::bench {

/// The world set with its grid, links and irradiance.
struct WorldBench {
    WorldBench();

    native::BvhView bvh_view() const { return {bvh.nodes.data(), bvh.leaves.data()}; }
    native::SurfelsView surfels() const { return host_surfels.view(); }
    native::GridView grid_view() const { return {world.grid().grid, starts.data(), entries.data()}; }
    double texels() const { return static_cast<double>(world.surfels().count); }

    Kernels& kernels;
    Bvh bvh;
    DeviceScene scene;  // with its hierarchy
    LightSet lights;    // without maps: rays settle them
    LobeLights lobe_lights;
    WorldSet world;
    HostSurfels host_surfels;            // what the pencils' texels see
    std::vector<SurfacePencil> pencils;  // of the world set
    std::vector<float4> irradiance;
    std::vector<int> starts;  // the grid in blocks of the native loops' width
    std::vector<float> entries;
};
WorldBench& world_bench();

/// Pencils on the film's lattice, with irradiance.
struct LatticeBench {
    LatticeBench();

    native::LatticeView view() const;
    FilmSurfels shown() const;
    PencilLattice lattice() const { return {pencils, at, coarsest, finest}; }

    static constexpr int coarsest = 16, finest = 8;  // spacings [pixels]
    HostSurfels host_surfels;
    std::vector<unsigned char> counts;
    std::vector<int> first, host_at;
    SurfacePencils pencils;
    std::vector<SurfacePencil> host_pencils;
    std::vector<float4> irradiance;
    Buffer<int> at;
};
LatticeBench& lattice_bench();

/// Floats of a list of vectors.
std::vector<float> floats(const std::vector<float4>& vectors);

}  // namespace pencil::bench
