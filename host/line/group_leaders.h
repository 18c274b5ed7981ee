// Groups of pencils that lie together, each with a leader: thesis ch. 7, "groups of pencils based on the proximity of their centers".
#pragma once

#include <glm/vec4.hpp>
#include <vector>

namespace pencil {

/// Splits `centres` by planes through medians until no group has more than `most` members, and returns of each group the member nearest to its
/// mean: (number of centres) / most leaders at least, as dense everywhere in proportion to the centres. `most` is at least 1.
std::vector<glm::vec4> group_leaders(const std::vector<glm::vec4>& centres, int most);

}  // namespace pencil
