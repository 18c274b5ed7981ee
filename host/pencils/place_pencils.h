// Candidate centres of projection (thesis 6.1.1): positions in the bounding box of geometry and lights.
#pragma once

#include <vector>

#include "pencils/flat_scene.h"

namespace pencil {

enum class Sequence { random, low_discrepancy };

/// Candidates first .. first + count of the set number `set`; each set has its own shift or stream.
std::vector<float4> place_pencils(const FlatScene& flat, Sequence sequence, int first, int count, int set, std::uint64_t seed);

}  // namespace pencil
