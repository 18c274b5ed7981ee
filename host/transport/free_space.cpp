#include "transport/free_space.h"

#include <algorithm>

#include "transport/find_enclosing.h"
#include "transport/rasterize_octahedral.h"

namespace pencil {

namespace {

std::shared_ptr<GeometryMaps> rasterized(Kernels& kernels, const DeviceScene& scene, const std::vector<float4>& centres, int n) {
    auto maps = std::make_shared<GeometryMaps>(kernels.device(), centres, n, "pencil");
    rasterize_octahedral(kernels, scene, *maps, 0, maps->count);
    return maps;
}

}  // namespace

FreeSpace::FreeSpace(Kernels& kernels, const DeviceScene& scene, const FlatScene& flat, const GeometryMaps* lights, int map_size)
    : scene_(scene), flat_(flat), map_size_(map_size) {
    auto camera = rasterized(kernels, scene, {float4(glm::vec3(flat.camera.origin), 0.0F)}, map_size);
    for (int shape : find_enclosing(kernels, scene, *camera)) rooms_.insert(shape);
    if (lights)
        for (int shape : find_enclosing(kernels, scene, *lights)) rooms_.insert(shape);
    rooms_.erase(-1);
}

std::vector<bool> FreeSpace::accepted(Kernels& kernels, const GeometryMaps& maps) const {
    std::vector<bool> result;
    for (int shape : find_enclosing(kernels, scene_, maps)) result.push_back(shape < 0 || rooms_.count(shape) > 0);
    return result;
}

std::shared_ptr<GeometryMaps> FreeSpace::create(Kernels& kernels, Sequence sequence, int count, int set, std::uint64_t seed) const {
    auto batch = rasterized(kernels, scene_, place_pencils(flat_, sequence, 0, count, set, seed), map_size_);
    std::vector<bool> keep = accepted(kernels, *batch);
    if (std::find(keep.begin(), keep.end(), false) == keep.end()) return batch;

    auto maps = std::make_shared<GeometryMaps>(kernels.device(), std::vector<float4>(static_cast<std::size_t>(count)), map_size_, "pencil");
    int filled = 0, tried = count;
    for (int round = 1;; ++round) {
        for (int tile = 0; tile < batch->count; ++tile)
            if (keep[static_cast<std::size_t>(tile)]) maps->copy_tile(*batch, tile, filled++);
        if (filled == count) return maps;
        batch = rasterized(kernels, scene_, place_pencils(flat_, sequence, tried, count - filled, set, seed), map_size_);
        tried += batch->count;
        keep = round < kMostRounds ? accepted(kernels, *batch) : std::vector<bool>(static_cast<std::size_t>(batch->count), true);
    }
}

}  // namespace pencil
