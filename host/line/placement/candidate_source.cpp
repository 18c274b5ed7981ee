#include "line/placement/candidate_source.h"

#include <algorithm>

#include "line/placement/box_candidates.h"
#include "line/placement/profile_candidates.h"
#include "line/placement/ray_candidates.h"
#include "util/error.h"

namespace pencil {

namespace {

/// Members take turns.
class MixedCandidates : public CandidateSource {
public:
    explicit MixedCandidates(std::vector<std::unique_ptr<CandidateSource>> members) : members_(std::move(members)) {}

    std::vector<float4> place(const CandidateQuery& query) override {
        const int m = static_cast<int>(members_.size()), end = query.first + query.count;
        std::vector<float4> centres(static_cast<std::size_t>(query.count));
        for (int member = 0; member < m; ++member) {
            // Numbers k of this member with query.first <= k m + member < end.
            CandidateQuery own = query;
            own.first = (query.first - member + m - 1) / m;
            own.count = (end - member + m - 1) / m - own.first;
            if (own.count <= 0) continue;
            const std::vector<float4> placed = members_[static_cast<std::size_t>(member)]->place(own);
            for (int k = 0; k < own.count; ++k)
                centres[static_cast<std::size_t>((own.first + k) * m + member - query.first)] = placed[static_cast<std::size_t>(k)];
        }
        return centres;
    }

    std::string describe() const override {
        std::string all;
        for (const auto& member : members_) all += (all.empty() ? "" : " + ") + member->describe();
        return all + " in equal parts";
    }

private:
    std::vector<std::unique_ptr<CandidateSource>> members_;
};

std::unique_ptr<CandidateSource> make_member(const PlacementScene& scene, Placement placement) {
    switch (placement) {
        case Placement::random:
            return std::make_unique<BoxCandidates>(scene, Sequence::random);
        case Placement::lds:
            return std::make_unique<BoxCandidates>(scene, Sequence::low_discrepancy);
        case Placement::near_surface:
            return std::make_unique<RayCandidates>(scene, placement, near_surface_rule(scene));
        case Placement::light_rays:
            return std::make_unique<RayCandidates>(scene, placement, light_rays_rule(scene));
        case Placement::camera_rays:
            return std::make_unique<RayCandidates>(scene, placement, camera_rays_rule(scene));
        case Placement::profile:
            return std::make_unique<ProfileCandidates>(scene);
    }
    throw UsageError("unknown placement");
}

}  // namespace

bool follows_rays(const std::vector<Placement>& mixture) {
    return std::any_of(
        mixture.begin(), mixture.end(),
        [](Placement p) { return p == Placement::near_surface || p == Placement::light_rays || p == Placement::camera_rays; });
}

bool fills_box_evenly(const std::vector<Placement>& mixture) {
    return std::all_of(
        mixture.begin(), mixture.end(), [](Placement p) { return p == Placement::random || p == Placement::lds; });
}

std::unique_ptr<CandidateSource> make_candidate_source(const PlacementScene& scene, const std::vector<Placement>& mixture) {
    if (mixture.empty()) throw UsageError("a placement of pencils is needed");
    std::vector<std::unique_ptr<CandidateSource>> members;
    for (std::size_t i = 0; i < mixture.size(); ++i) {
        if (std::find(mixture.begin(), mixture.begin() + static_cast<std::ptrdiff_t>(i), mixture[i]) !=
            mixture.begin() + static_cast<std::ptrdiff_t>(i))
            throw UsageError("a mixture of placements must name each once");
        members.push_back(make_member(scene, mixture[i]));
    }
    if (members.size() == 1) return std::move(members.front());
    return std::make_unique<MixedCandidates>(std::move(members));
}

}  // namespace pencil
