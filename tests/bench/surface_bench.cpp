#include "bench/surface_bench.h"

#include "shared/film.h"
#include "surface/film_seeds.h"
#include "surface/limit_reuse.h"
#include "surface/measure_hemispheres.h"

namespace pencil::bench {
namespace {

constexpr int seed_spacing = 32, world_map = 8, film_map = 4;

/// Some irradiance that differs from pencil to pencil.
std::vector<float4> varied(int count) {
    std::vector<float4> out;
    for (int i = 0; i < count; ++i) out.emplace_back(1 + i % 7, 1 + i % 5, 1 + i % 3, 0);
    return out;
}

/// The blocks of the device's grid in blocks of the native loops' width.
void repack(const DeviceGrid& grid, std::vector<int>& starts, std::vector<float>& entries) {
    const std::vector<int> cells = grid.starts.read();
    const std::vector<float> from = grid.entries.read();
    const auto width = static_cast<std::size_t>(device()->packet_width()), lanes = static_cast<std::size_t>(native::grid_lanes());
    for (std::size_t cell = 0; cell + 1 < cells.size(); ++cell) {
        starts.push_back(static_cast<int>(entries.size() / (ENTRY_FIELDS * lanes)));
        std::size_t lane = lanes;
        for (std::size_t e = static_cast<std::size_t>(cells[cell]) * width; e < static_cast<std::size_t>(cells[cell + 1]) * width; ++e) {
            const float* entry = from.data() + e / width * ENTRY_FIELDS * width + e % width;
            if (entry[ENTRY_RADIUS * width] == 0.0F) continue;
            if (lane == lanes) {
                entries.resize(entries.size() + ENTRY_FIELDS * lanes, 0.0F);
                lane = 0;
            }
            float* block = entries.data() + entries.size() - ENTRY_FIELDS * lanes + lane++;
            for (std::size_t f = 0; f < ENTRY_FIELDS; ++f) block[f * lanes] = entry[f * width];
        }
    }
    starts.push_back(static_cast<int>(entries.size() / (ENTRY_FIELDS * lanes)));
}

/// `lights`: none, since nothing has lobes.
WorldSet covered(Kernels& kernels, const DeviceScene& scene, const LobeLights& lights) {
    const Workbench& bench = workbench();
    WorldSet world(kernels, scene, sizes().world, 0, lights);
    const FilmPixels pixels(bench.film);
    world.cover(seed_pencils(kernels, pixels, pixels_of_cells(pixels, std::min(seed_spacing, sizes().film / 4)), world_map));
    world.gather(world_map, 0);
    return world;
}

}  // namespace

WorldBench::WorldBench()
    : kernels(workbench().kernels),
      bvh(build_bvh(workbench().flat.triangles)),
      scene(device(), workbench().flat, bvh),
      lights(device(), workbench().lights.samples.read(), 0),
      world(covered(kernels, scene, lobe_lights)),
      host_surfels(world.surfels()),
      pencils(world.pencils().data.read(0, static_cast<std::size_t>(world.pencils().count))),
      irradiance(varied(world.pencils().count)) {
    world.pencils().irradiance.write(irradiance);
    repack(world.grid(), starts, entries);
}

WorldBench& world_bench() {
    static WorldBench made;
    return made;
}

LatticeBench::LatticeBench()
    : host_surfels(workbench().film.surfels()),
      counts(workbench().film.counts().read()),
      first(workbench().film.first_surfel().read()),
      host_at(counts.size(), -1),
      pencils(device(), 1, film_map) {
    Kernels& kernels = workbench().kernels;
    const Film& film = workbench().film;
    for (int spacing = coarsest; spacing >= finest; spacing /= 2) {
        ChosenSurfels chosen;
        for (int y = 0; y < film.height(); y += spacing)
            for (int x = 0; x < film.width(); x += spacing) {
                const auto pixel = static_cast<std::size_t>(y * film.width() + x);
                if (host_at[pixel] >= 0 || (counts[pixel] & FILM_COUNT_MASK) == 0) continue;
                host_at[pixel] = pencils.count + static_cast<int>(chosen.surfels.size());
                chosen.add(first[pixel], static_cast<uint>(pixel), film.viewer(first[pixel]));
            }
        place_surface_pencils(kernels, film.surfels(), chosen, pencils, spacing);
    }
    Surfels seen(device(), pencils.count * pencils.texels(), "surfels of film pencils");
    trace_hemispheres(kernels, world_bench().scene, pencils, 0, pencils.count, {}, seen);
    measure_hemispheres(kernels, seen, 0, 0, pencils.count, pencils);
    at = Buffer<int>(device(), host_at, "film pencils by pixel");
    limit_reuse(kernels, pencils, at, finest, 0, film.width(), film.height());
    irradiance = varied(pencils.count);
    pencils.irradiance.write(irradiance);
    host_pencils = pencils.data.read(0, static_cast<std::size_t>(pencils.count));
}

FilmSurfels LatticeBench::shown() const {
    const Film& film = workbench().film;
    return {film.surfels(), film.counts(), film.first_surfel(), film.width(), film.height()};
}

native::LatticeView LatticeBench::view() const {
    const Film& film = workbench().film;
    return {host_surfels.view(), counts.data(), first.data(), host_pencils.data(), host_at.data(), coarsest, finest,
            film.width(),        film.height()};
}

LatticeBench& lattice_bench() {
    static LatticeBench made;
    return made;
}

std::vector<float> floats(const std::vector<float4>& vectors) {
    std::vector<float> out;
    for (const float4& v : vectors) out.insert(out.end(), {v.x, v.y, v.z});
    return out;
}

}  // namespace pencil::bench
