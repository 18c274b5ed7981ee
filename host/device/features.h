// What a scene and its options need, found once; to_defines is the only place that turns it into kernel defines.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "cl/build_ahead.h"
#include "cl/program.h"
#include "device/map_shape.h"
#include "pencils/flat_scene.h"
#include "shared/weights.h"

namespace pencil {

struct Features {
    bool smooth = false;    // some triangle has vertex normals: interpolated shading normals
    int film_samples = 16;  // visibility samples per pixel
    std::set<int> models;   // of reflection, that some material has (shared/material.h)
    bool blends = false;    // some material is one of two others, or has a back of its own
    bool textures = false;
    bool clear = false;        // some surface lets light pass unturned: shadows have shares
    bool relief = false;       // some texture turns shading normals
    bool lobes = false;        // some material scatters along lobes, which are followed
    bool wide_camera = false;  // rays of the film do not all come from one point
    bool far_light = false;    // some light comes from infinitely far away, or from a spot
    bool sky = false;          // there is light from infinitely far away all around
    bool glow = false;         // some emitter's radiance is a texture
    /// Surfels carry the direction that they are seen from.
    bool outgoing() const { return lobes || sky || glow; }
    /// Fields of a surfel (shared/surfel.h).
    int surfel_fields() const;
    // What the method needs:
    int weights = PENCIL_WEIGHTS_DPDF;     // form of the quadrature weights (shared/weights.h)
    int cell_grid = 0;                     // root of the greatest number of directions that sample cells, 0 for weights that are none
    int map_kind = PENCIL_MAP_OCTAHEDRAL;  // of pencils and light samples (shared/map_kind.h)
    bool atlas_image = false;              // radiance maps are looked up as an image
    bool wide_bvh = false;                 // the hierarchy has eight children per node (shared/bvh.h)
    bool bvh = false;                      // rays through the hierarchy decide visibility, geometry maps do not
};

/// The part that scene and film decide.
/// `lobes`: whether the method follows them, or else takes them for even.
Features scene_features(const FlatScene& scene, int film_samples, bool lobes);
Defines to_defines(const Features& features, int block);

/// A kernel that a render is sure to launch, and about how many work-items at once.
struct SureKernel {
    std::string name;
    std::size_t items = 1;
};
/// Items of a kernel that works on the texels of a set of pencils: there are more.
constexpr std::size_t texels_of_set = 65536;

/// Kernels of one render: the program cache with the render's specialisation.
class Kernels {
public:
    Kernels(std::shared_ptr<Device> device, const Features& features) : cache_(std::move(device)), features_(features) {}
    /// Kernel `name` from kernels/<name>.cl, built with its program (program_of).
    Launch get(const std::string& name);
    /// Has them built beside the render, where that is allowed (cl/build_ahead.h).
    void build_ahead(const std::vector<SureKernel>& sure);
    const std::shared_ptr<Device>& device() const { return cache_.device(); }
    const Features& features() const { return features_; }
    ProgramCache& cache() { return cache_; }
    /// Called before every launch; may throw to stop the work (StageClock::poll).
    void before_launch(std::function<void()> call) { before_launch_ = std::move(call); }
    /// That call, where something else than a launch is waited for.
    void poll() const {
        if (before_launch_) before_launch_();
    }
    /// Maps of the render's kind with as many texels as octahedral ones of `width`.
    MapShape map_shape(int width) const { return {features_.map_kind, width}; }
    /// Packets per work-item (PENCIL_BLOCK).
    int block() const { return device()->profile().block; }
    std::size_t blocks(int surfels) const {
        return (packets(surfels) + static_cast<std::size_t>(block()) - 1) / static_cast<std::size_t>(block());
    }
    /// Work-items that cover `surfels` in packets.
    std::size_t packets(int surfels) const {
        int width = device()->packet_width();
        return static_cast<std::size_t>((surfels + width - 1) / width);
    }

private:
    ProgramCache cache_;
    Features features_;
    std::function<void()> before_launch_;
    std::unique_ptr<BuildAhead> ahead_;
};

}  // namespace pencil
