#include "bench/native/native.h"
#include "bench/native/octahedral.h"
#include "bench/native/parallel.h"
#include "bench/native/write_surfel.h"

namespace pencil::native {

void gather_surfels(const SceneView& scene, const MapsView& maps, int first, int count, float* surfels, std::size_t capacity) {
    const int n = maps.n;
    parallel_blocks(count * n * n, 256, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            const int tile = first + i / (n * n);
            const Texel texel = surfel_texel(i % (n * n), n);
            const Hit& hit =
                maps.hits[static_cast<std::size_t>(tile) * maps.tile_texels() + static_cast<std::size_t>(tile_index(texel, n))];
            write_surfel(scene, hit, load_point(maps.cops[tile]), texel_direction(texel, n), surfels + i, capacity);
        }
    });
}

}  // namespace pencil::native
