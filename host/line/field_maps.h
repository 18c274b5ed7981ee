// Between fields of pencils and sets on the device: their light in the maps of a set, and the light of sets in a field.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "device/pencil_set.h"
#include "options/pencil_field.h"
#include "pencils/flat_scene.h"

namespace pencil {

/// Centres in scene units. UsageError if one lies outside of the scene's box: the field is of another scene.
std::vector<float4> field_centres(const PencilField& field, const FlatScene& flat);

/// Adds the light of the field to the maps of a set with the same centres. `unit`: radiance of the field per radiance on the device.
void add_field(const PencilField& field, double unit, PencilSet& set);

/// Makes it all the light of the maps, whose radiance is not defined. `weights`: the density weights of interior texels are there; the gutters
/// get theirs.
void set_field(const PencilField& field, double unit, bool weights, PencilSet& set);

/// Light of one set after another that share their maps.
class FieldSum {
public:
    FieldSum(const PencilSet& set, const FlatScene& flat, double free_share);

    /// Adds `factor` times the light of the set's maps.
    void add(const PencilSet& set, const glm::dvec3& factor);
    /// So far, rounded to float.
    PencilField field() const;

private:
    PencilField field_;
    std::vector<double> sum_;
    double unit_;
};

}  // namespace pencil
