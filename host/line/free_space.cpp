#include "line/free_space.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "line/find_enclosing.h"
#include "line/find_sides.h"
#include "visibility/geometry_maps.h"

namespace pencil {

namespace {

std::shared_ptr<GeometryMaps> made_maps(Kernels& kernels, const DeviceScene& scene, const std::vector<float4>& centres, int n) {
    auto maps = std::make_shared<GeometryMaps>(kernels.device(), centres, kernels.map_shape(n), "pencil");
    make_geometry_maps(kernels, scene, *maps, 0, maps->count);
    return maps;
}

std::shared_ptr<GeometryMaps> empty_maps(Kernels& kernels, int count, int n) {
    return std::make_shared<GeometryMaps>(kernels.device(), std::vector<float4>(static_cast<std::size_t>(count)), kernels.map_shape(n),
                                          "pencil");
}

/// Candidates of the next round, so that as many as are missing are likely to be accepted at the rate seen so far.
int next_batch(int missing, int filled, int tried, int count) {
    constexpr double lowest_rate = 0.05;  // bounds the work where hardly any candidate is accepted
    const double rate = std::max(static_cast<double>(filled) / tried, lowest_rate);
    return std::min(static_cast<int>(std::ceil(missing / rate)), count);
}

/// A field of the surfels that holds indices.
std::vector<int> read_indices(const Surfels& surfels, int field) {
    const std::size_t first = static_cast<std::size_t>(field) * static_cast<std::size_t>(surfels.capacity);
    const std::vector<float> bits = surfels.data.read(first, static_cast<std::size_t>(surfels.count));
    std::vector<int> indices(bits.size());
    if (!bits.empty()) std::memcpy(indices.data(), bits.data(), bits.size() * sizeof(int));
    return indices;
}

}  // namespace

FreeSpace::FreeSpace(Kernels& kernels, const DeviceScene& scene, const FlatScene& flat, const Surfels& film, const GeometryMaps* lights,
                     int map_size)
    : scene_(scene), flat_(flat), map_size_(map_size), reached_(side_words(static_cast<std::size_t>(flat.shape_count)), 0U) {
    auto camera = made_maps(kernels, scene, {float4(glm::vec3(flat.camera.origin), 0.0F)}, map_size);
    for (int shape : find_enclosing(kernels, scene, *camera)) rooms_.insert(shape);
    reach_film(film);
    if (lights) {
        for (int shape : find_enclosing(kernels, scene, *lights)) rooms_.insert(shape);
        const std::vector<uint> sides = find_sides(kernels, scene, *lights);
        for (std::size_t row = 0; row < sides.size(); row += reached_.size()) reach_row(&sides[row]);
    }
    rooms_.erase(-1);
    any_reached_ = std::any_of(reached_.begin(), reached_.end(), [](uint word) { return word != 0; });
}

/// Reaches the sides that the film shows.
void FreeSpace::reach_film(const Surfels& film) {
    std::vector<std::size_t> shape_of_plane(flat_.planes.size());
    for (const Triangle& t : flat_.triangles) shape_of_plane[static_cast<std::size_t>(t.plane)] = static_cast<std::size_t>(t.shape);
    const std::vector<int> planes = read_indices(film, SURFEL_PLANE), materials = read_indices(film, SURFEL_MATERIAL);
    for (std::size_t i = 0; i < planes.size(); ++i) {
        if (planes[i] < 0) continue;
        const bool back = materials[i] < 0;
        const int material = back ? ~materials[i] : materials[i];
        if (back && flat_.materials[static_cast<std::size_t>(material)].albedo.w == 0.0F) continue;
        const std::size_t side = 2 * shape_of_plane[static_cast<std::size_t>(planes[i])] + (back ? 1 : 0);
        reached_[side / 32] |= 1U << (side % 32);
    }
}

/// Adds a row of find_sides; true if one of its sides is new.
bool FreeSpace::reach_row(const uint* row) {
    bool grown = false;
    for (std::size_t w = 0; w < reached_.size(); ++w) {
        grown = grown || (row[w] & ~reached_[w]) != 0;
        reached_[w] |= row[w];
    }
    return grown;
}

bool FreeSpace::meets_reached(const uint* row) const {
    if (!any_reached_) return true;  // neither film nor lights show a surface: there is nothing to lose
    for (std::size_t w = 0; w < reached_.size(); ++w)
        if ((row[w] & reached_[w]) != 0) return true;
    return false;
}

std::vector<bool> FreeSpace::accepted(Kernels& kernels, const GeometryMaps& maps) {
    const auto tiles = static_cast<std::size_t>(maps.count);
    const std::vector<int> enclosing = find_enclosing(kernels, scene_, maps);
    const std::vector<uint> sides = find_sides(kernels, scene_, maps);
    std::vector<bool> outside(tiles), result(tiles, false);
    for (std::size_t tile = 0; tile < tiles; ++tile) outside[tile] = enclosing[tile] < 0 || rooms_.count(enclosing[tile]) > 0;
    // What one centre reaches may connect another, also an earlier one.
    for (bool grown = true; grown;) {
        grown = false;
        for (std::size_t tile = 0; tile < tiles; ++tile) {
            const uint* row = sides.data() + tile * reached_.size();
            if (result[tile] || !outside[tile] || !meets_reached(row)) continue;
            result[tile] = true;
            grown = reach_row(row) || grown;
        }
    }
    candidates_ += maps.count;
    const auto solid = static_cast<int>(std::count(outside.begin(), outside.end(), false));
    in_solids_ += solid;
    unreached_ += static_cast<int>(std::count(result.begin(), result.end(), false)) - solid;
    return result;
}

double FreeSpace::share() const {
    if (given_share_ >= 0) return given_share_;
    const int rejected = in_solids_ + unreached_;
    return candidates_ > rejected ? 1.0 - static_cast<double>(rejected) / candidates_ : 1.0;
}

CentreSpace FreeSpace::space() const {
    const glm::dvec3 size = flat_.high - flat_.low;
    return {flat_.low, flat_.high, share() * size.x * size.y * size.z};
}

std::shared_ptr<GeometryMaps> FreeSpace::create(Kernels& kernels, CandidateSource& source, int count, int set, const PowerSeen& power) {
    auto batch = made_maps(kernels, scene_, source.place({set, 0, count, power}), map_size_);
    std::vector<bool> keep = accepted(kernels, *batch);
    if (std::find(keep.begin(), keep.end(), false) == keep.end()) return batch;

    auto maps = empty_maps(kernels, count, map_size_);
    int filled = 0, tried = count;
    for (int round = 1;; ++round) {
        for (int tile = 0; tile < batch->count && filled < count; ++tile)
            if (keep[static_cast<std::size_t>(tile)]) maps->copy_tile(*batch, tile, filled++);
        if (filled == count) return maps;
        if (round == most_rounds) break;
        batch = made_maps(kernels, scene_, source.place({set, tried, next_batch(count - filled, filled, tried, count), power}), map_size_);
        tried += batch->count;
        keep = accepted(kernels, *batch);
    }
    if (filled == 0) return batch;
    auto fewer = empty_maps(kernels, filled, map_size_);
    for (int tile = 0; tile < filled; ++tile) fewer->copy_tile(*maps, tile, tile);
    return fewer;
}

}  // namespace pencil
