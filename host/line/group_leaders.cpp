#include "line/group_leaders.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace pencil {

namespace {

using Iterator = std::vector<glm::vec4>::iterator;

int widest_axis(Iterator first, Iterator last) {
    glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
    for (Iterator c = first; c != last; ++c) {
        low = glm::min(low, glm::vec3(*c));
        high = glm::max(high, glm::vec3(*c));
    }
    const glm::vec3 width = high - low;
    const int of_xy = width.x >= width.y ? 0 : 1;
    return width[of_xy] >= width.z ? of_xy : 2;
}

glm::vec4 leader(Iterator first, Iterator last) {
    glm::dvec3 mean(0);
    for (Iterator c = first; c != last; ++c) mean += glm::dvec3(*c);
    mean /= static_cast<double>(last - first);
    const auto distance = [&](const glm::vec4& c) { return glm::distance(glm::dvec3(c), mean); };
    return *std::min_element(first, last, [&](const glm::vec4& a, const glm::vec4& b) { return distance(a) < distance(b); });
}

void split(Iterator first, Iterator last, std::ptrdiff_t most, std::vector<glm::vec4>& leaders) {
    if (last - first <= most) {
        leaders.push_back(leader(first, last));
        return;
    }
    const int axis = widest_axis(first, last);
    const Iterator middle = first + (last - first) / 2;
    std::nth_element(first, middle, last, [axis](const glm::vec4& a, const glm::vec4& b) { return a[axis] < b[axis]; });
    split(first, middle, most, leaders);
    split(middle, last, most, leaders);
}

}  // namespace

std::vector<glm::vec4> group_leaders(const std::vector<glm::vec4>& centres, int most) {
    std::vector<glm::vec4> order = centres, leaders;
    if (!order.empty()) split(order.begin(), order.end(), most, leaders);
    return leaders;
}

}  // namespace pencil
