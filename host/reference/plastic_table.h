// How much light gets through the varnish of a plastic, and how much its inside keeps.
#pragma once

#include <vector>

namespace pencil {

/// For one index of refraction and distribution of facets; for one roughness, or for all up to one.
class PlasticTable {
public:
    /// `eta`: index inside over outside. `varies`: roughness takes any value from 0 to `alpha`.
    PlasticTable(float eta, float alpha, bool beckmann, bool varies);

    /// Share of the light from a direction at `cosine` to the normal that the boundary lets through.
    float transmitted(float cosine, float alpha) const;
    /// Share of diffuse light from below that the boundary reflects back.
    float reflected_inside(float alpha) const;

private:
    double level(float alpha) const;

    float alpha_;
    std::vector<std::vector<float>> transmitted_;  // for each level of roughness, at equal steps of the cosine
    std::vector<float> inside_;                    // for each level
};

}  // namespace pencil
