// Candidates uniform over the bounding box of geometry and lights (thesis 6.1.1).
#pragma once

#include "line/placement/candidate_source.h"
#include "pencils/place_pencils.h"

namespace pencil {

class BoxCandidates : public CandidateSource {
public:
    BoxCandidates(const PlacementScene& scene, Sequence sequence) : flat_(scene.flat), sequence_(sequence), seed_(scene.seed) {}

    std::vector<float4> place(const CandidateQuery& query) override {
        return place_pencils(flat_, sequence_, query.first, query.count, query.set, seed_);
    }
    std::string describe() const override { return sequence_ == Sequence::random ? "random" : "lds"; }

private:
    const FlatScene& flat_;
    Sequence sequence_;
    std::uint64_t seed_;
};

}  // namespace pencil
