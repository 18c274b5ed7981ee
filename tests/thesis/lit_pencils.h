// The common part of the look-up experiment: a scene's film surfels, and a set of pencils lit by light samples, in the octahedral maps of
// the renderer and resampled into maps of any other kind.
#pragma once

#include <filesystem>
#include <memory>

#include "device/pencil_set.h"
#include "film/film.h"
#include "reference/map_ref.h"
#include "scene/scene.h"

namespace pencil::thesis {

struct LookUpOptions {
    std::filesystem::path scene;
    int resolution = 512;  // surfels: one per pixel
    int pencils = 128;
    int texels = 4096;  // of one pencil's map, all tiles together, as near as a whole tile size comes
    int repeats = 25;
};

/// Index of a texel, gutter included, in a buffer of tiles of n x n (kernels/shared/atlas.h).
std::size_t texel_index(int tile, int x, int y, int n);

class LitPencils {
public:
    LitPencils(const std::shared_ptr<Device>& device, const LookUpOptions& options);

    Kernels& kernels() { return kernels_; }
    const Surfels& surfels() const { return film_.surfels(); }
    const std::vector<ref::dvec3>& positions() const { return positions_; }  // of the surfels
    const Buffer<float4>& cops() const { return set_.maps->cops; }
    const std::vector<float4>& host_cops() const { return host_cops_; }

    /// Maps of all pencils, `map.tiles` tiles of n x n each, gutters filled: rgb radiance, w distance [scene units].
    std::vector<float4> fill(const ref::Map& map, int n) const;

private:
    void make_pencils(const std::shared_ptr<Device>& device, const LookUpOptions& options);
    glm::dvec4 seen(int pencil, const ref::dvec3& direction) const;

    Scene scene_;
    std::vector<LightForm> forms_;
    FlatScene flat_;
    Kernels kernels_;
    DeviceScene device_scene_;
    Film film_;
    PencilSet set_;
    std::vector<float4> radiance_, host_cops_;
    std::vector<Hit> hits_;
    std::vector<ref::dvec3> positions_;
};

}  // namespace pencil::thesis
