// Candidates on the free segments of probing rays (thesis 6.2.2): near surfaces, on rays from lights, on rays from the camera.
#pragma once

#include <map>

#include "line/placement/candidate_source.h"
#include "pencils/probing_rays.h"

namespace pencil {

/// What makes one placement of this kind differ from another.
struct ProbingRule {
    std::string name, nothing;  // `nothing`: what is missing if there are no rays
    std::function<std::vector<ProbingRay>(const ProbingStream&, int first, int count)> start;
    double (*distance)(const Segment&, double u, double extent);
    bool continued;  // set k lies on segment k of the paths, the first set on the first
};

ProbingRule near_surface_rule(const PlacementScene& scene);
ProbingRule light_rays_rule(const PlacementScene& scene);
ProbingRule camera_rays_rule(const PlacementScene& scene);

class RayCandidates : public CandidateSource {
public:
    RayCandidates(const PlacementScene& scene, Placement placement, ProbingRule rule)
        : scene_(scene), placement_(placement), rule_(std::move(rule)) {}

    std::vector<float4> place(const CandidateQuery& query) override;
    std::string describe() const override;

private:
    std::vector<ProbingRay> rays(const CandidateQuery& query);

    PlacementScene scene_;
    Placement placement_;
    ProbingRule rule_;
    std::map<int, std::vector<ProbingHit>> ends_;  // of the rays of each set so far, of continued rays
    int placed_ = 0, in_box_ = 0;                  // candidates, and those of them that had no free segment
};

}  // namespace pencil
