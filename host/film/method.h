// A method of rendering: says what it needs, does one step at a time, explains itself. Nothing but the table in render/ knows which there
// are; a method lies in a folder of its own.
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "device/features.h"
#include "options/layer.h"
#include "options/pencil_field.h"
#include "options/render_result.h"
#include "pencils/flat_scene.h"
#include "shared/weights.h"
#include "util/archive.h"
#include "visibility/visibility_path.h"

namespace pencil {

/// What a method needs to have before its first step.
struct MethodNeeds {
    std::vector<MapBatch> maps;            // geometry maps that will be made, as far as can be told
    bool hierarchy = false;                // some kernel follows rays, whatever way the maps are made
    bool rays_for_visibility = false;      // Features::bvh
    bool lobes = false;                    // it follows lobes of materials; else they count as even
    int weights = PENCIL_WEIGHTS_DPDF;     // Features::weights
    int cell_grid = 0;                     // Features::cell_grid
    int map_kind = PENCIL_MAP_OCTAHEDRAL;  // Features::map_kind
    bool atlas = false;                    // radiance maps of pencils are looked up (Features::atlas_image)
    std::vector<SureKernel> kernels;       // that every render by it launches, beside those of the film
};

class Method {
public:
    virtual ~Method() = default;

    /// One step: a pass, or a bounce. False if that was the last. Throws Stopped where it was stopped; what is finished by then stays.
    virtual bool advance() = 0;
    /// The image as far as it has come, beauty first; empty before there is one.
    virtual std::vector<Layer> snapshot() const = 0;
    /// The same, at the end: nothing may follow.
    virtual std::vector<Layer> take() { return snapshot(); }
    /// Whether there is light that does not depend on the camera, and look() can show it.
    virtual bool can_look() const { return false; }
    /// The image once more, from the camera that the scene has now, by the light that is there: the beauty.
    virtual void look() {}
    /// Gives back what only a next step would need: there is none.
    virtual void let_go() {}
    /// Estimated relMSE of the beauty; infinite if not known.
    virtual double estimated_error() const { return std::numeric_limits<double>::infinity(); }
    /// What a check by light paths says of it; nothing if there was none.
    virtual CertifiedError certified_error() const { return {}; }
    /// Whether the method can go on where another one stopped after a step: then transfer() names all that the next step needs of those before.
    /// A method that has read it must not have made a step. ArchiveError.
    virtual bool resumable() const { return false; }
    virtual void transfer(Archive&) {}
    /// RenderResult::field.
    virtual std::shared_ptr<PencilField> field() const { return {}; }
    /// Decisions and what was left out, one sentence each.
    virtual std::vector<std::string> explain() const = 0;
};

}  // namespace pencil
