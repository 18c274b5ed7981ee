// Candidates by the illumination profile (thesis 6.2.2): where much power passes and much of the scene is visible, found by small maps.
#pragma once

#include "line/placement/candidate_source.h"

namespace pencil {

class ProfileCandidates : public CandidateSource {
public:
    explicit ProfileCandidates(const PlacementScene& scene) : scene_(scene) {}

    std::vector<float4> place(const CandidateQuery& query) override;
    std::string describe() const override { return "profile"; }

private:
    PlacementScene scene_;
};

/// Per tile the area of reflecting sides that it shows, seen face on: mean over the sphere of the squared distance, nothing seen counting
/// 0 [scene units^2].
std::vector<double> visible_area(const FlatScene& flat, const GeometryMaps& maps);

}  // namespace pencil
