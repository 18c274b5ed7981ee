// One pencil set after the other: creation, initial gather, transport. Knows kernels and sets, not the film.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"
#include "device/stage_clock.h"
#include "device/surfels.h"
#include "line/free_space.h"
#include "line/placement/candidate_source.h"
#include "line/project_rays.h"
#include "line/weights.h"
#include "options/render_options.h"

namespace pencil {

/// Device seconds of making one set.
struct SetTimes {
    double maps = 0, transport = 0;
};

class PencilSolver {
public:
    PencilSolver(Kernels& kernels, const DeviceScene& scene, FreeSpace& free_space, CandidateSource& candidates, const LightSet& lights,
                 const RenderOptions& options, StageClock& clock);

    /// Set number `index` of the series: its centres, geometry maps. The other arguments are those of fill(): the
    /// light that the set is to carry, on which its centres may depend.
    PencilSet create(int index, const PencilSet* source, bool emission, bool direct);

    /// Geometry maps of given centres [scene units].
    PencilSet create_at(const std::vector<float4>& centres);
    /// Other centres for some tiles of a set, with their geometry maps; light and weights stay.
    void replace(const PencilSet& set, const std::vector<int>& tiles, const std::vector<float4>& centres);

    /// What the texels of `target` send to their centres, which becomes its radiance: emission that the maps carry (`emission`), reflected
    /// direct light (`direct`), and the radiance of `source` after one more bounce (if not null; thesis alg. 6.3). With `weights` the
    /// quadrature weights of its texels are made too (alg. 6.1), where the form needs any.
    void fill(PencilSet& target, const PencilSet* source, bool emission, bool direct, bool weights);

    /// The same pencils with the light of `set` after one more bounce, and reflected direct light where it joins (`direct`).
    PencilSet reflect(const PencilSet& set, bool direct);

    /// The weights alone; without any the radiance of `target` stays undefined. Gutters are left alone.
    void weigh(PencilSet& target);

    /// Adds the radiance of `source` reflected by the surfels, and the light of their own rays where the form of weights has any; `rays`
    /// says which. `visible` gets the number of pencils that each surfel sees. `what`: "pencil transport" or "projection-scatter".
    void project(const Surfels& surfels, const PencilSet& source, const RayChoice& rays, Buffer<float>& outgoing, Buffer<int>& visible,
                 const std::string& what);

    const SetTimes& times() const { return times_; }
    void reset_times() { times_ = {}; }

private:
    std::vector<float4> power_seen(std::shared_ptr<GeometryMaps> maps, const PencilSet* source, bool emission, bool direct);
    int form() const { return kernels_.features().weights; }
    Buffer<uint> masks(const Surfels& surfels, int pencils) const;
    void weigh_tiles(PencilSet& target, const GeometryMaps& seen, int first, int count, const Surfels& surfels, Buffer<uint>& mask);
    void weigh_texels(PencilSet& target, const GeometryMaps& seen);
    void fill_texels(PencilSet& target, const PencilSet* source, bool emission, bool direct, bool weights);
    bool has_coarse(int width, const PencilSet& set) const { return width > 0 && width < set.maps->shape.width; }
    std::shared_ptr<GeometryMaps> coarse_maps(const PencilSet& set, int width);
    void send(const GeometryMaps& maps, int first, int count, const PencilSet* source, bool emission, bool direct, Surfels& surfels,
              Buffer<float>& outgoing, Buffer<int>& visible);

    Kernels& kernels_;
    const DeviceScene& scene_;
    FreeSpace& free_space_;
    CandidateSource& candidates_;
    const LightSet& lights_;
    const RenderOptions& options_;
    StageClock& clock_;
    WeightTables tables_;
    int sets_ = 0;  // filled so far
    SetTimes times_;
};

}  // namespace pencil
