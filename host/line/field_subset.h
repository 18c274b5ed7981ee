// The pencils of a field that one view after the other uses, if it is not to use all (thesis ch. 7, "subsets of pencils loaded as the camera
// moves"). Pencils that the film sees are taken first, in the order of the field: what `pencil bake` writes begins with few and evenly spread
// ones, so that taking them from the front thins them evenly, and the next view takes mostly the same. What has been read stays.
#pragma once

#include <vector>

#include "device/device_scene.h"
#include "device/features.h"
#include "device/surfels.h"
#include "options/pencil_field.h"

namespace pencil {

/// Which pencils stand in which slot, by the numbers of those that see the film: no device, no light.
class SubsetSlots {
public:
    explicit SubsetSlots(int slots) : pencil_(static_cast<std::size_t>(slots), -1) {}

    /// `seen`: per pencil, how much of the film sees it. Of those that are still wanted none moves. Returns the slots that have changed.
    std::vector<int> choose(const std::vector<int>& seen);
    /// Pencil of each slot.
    const std::vector<int>& pencils() const { return pencil_; }

private:
    std::vector<int> pencil_;
};

/// Density of the chosen pencils where the film sees them, relative to that of all of `seen`: they count as so many of a whole field.
double subset_density(const std::vector<int>& seen, int slots);

class FieldSubset {
public:
    /// `field`: all but its light, which comes from `source`; both must outlive it. `centres`: of the field [scene units].
    FieldSubset(const PencilField& field, FieldSource& source, const std::vector<float4>& centres, int slots);

    /// Chooses for what these surfels show, some of them; reads what is new. Returns the slots that have changed.
    std::vector<int> choose(Kernels& kernels, const DeviceScene& scene, const Surfels& film);

    /// The chosen pencils with their light, each in its slot.
    const PencilField& chosen() const { return chosen_; }
    /// Their centres [scene units].
    std::vector<float4> centres(const std::vector<int>& slots) const;
    /// Of the scene's box, which chosen pencils fill as evenly as all fill the field's share.
    double share() const { return share_; }
    /// Pencils of the field that have been read so far.
    int read() const { return read_; }

private:
    void load(int slot);

    const PencilField& field_;
    FieldSource& source_;
    std::vector<float4> all_centres_;
    Buffer<float4> centres_on_device_;
    SubsetSlots slots_;
    PencilField chosen_;
    double share_ = 1;
    int read_ = 0;
    std::vector<std::vector<float>> light_;  // of each pencil of the field that has been read
};

}  // namespace pencil
