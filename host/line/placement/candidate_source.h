// Where pencils may come to lie, before the rules of FreeSpace: one interface for every placement (thesis 6.1.1 and 6.2.2).
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"
#include "options/render_options.h"

namespace pencil {

/// Mean radiance (rgb) that passes through each tile of geometry maps, of the light that the next set is to carry.
using PowerSeen = std::function<std::vector<float4>(std::shared_ptr<GeometryMaps>)>;

/// Asks for candidates first .. first + count of set number `set`. Each set is a sample of its own: random shifts are new for every set,
/// placement and seed. Sets are asked for in order.
struct CandidateQuery {
    int set = 0, first = 0, count = 0;
    PowerSeen power;  // may be empty: all candidates see the same
};

class CandidateSource {
public:
    virtual ~CandidateSource() = default;
    /// `count` centres [scene units]. A source that finds nothing to start from gives points of the scene's box.
    virtual std::vector<float4> place(const CandidateQuery& query) = 0;
    /// What it does, and what it had to do instead, for --explain.
    virtual std::string describe() const = 0;
};

/// True if a member follows probing rays: the device scene needs a hierarchy.
bool follows_rays(const std::vector<Placement>& mixture);

/// True if all members spread candidates evenly over the scene's box.
bool fills_box_evenly(const std::vector<Placement>& mixture);

/// What sources are made from; all of it must outlive them. The device scene has a hierarchy if the mixture follows rays.
struct PlacementScene {
    Kernels& kernels;
    const DeviceScene& device_scene;
    const Scene& scene;
    const FlatScene& flat;
    std::uint64_t seed;
};

/// One placement, or several in turn: candidate i of a mixture of m is number i / m of its member i mod m, so a mixture is the union of
/// its members' own sets. UsageError if the mixture is empty or names one placement twice.
std::unique_ptr<CandidateSource> make_candidate_source(const PlacementScene& scene, const std::vector<Placement>& mixture);

}  // namespace pencil
