// V(x, y) of thesis eq. (5.17) by trying all triangles: 1 if the segment meets none between its ends. Triangles in the plane of x (and
// of an emitter at y) do not count, so no epsilon is needed; both faces block. The margin tells ties from decisions.
#pragma once

#include <initializer_list>

#include "reference/raycast_ref.h"

namespace pencil::ref {

struct Visibility {
    bool visible = true;
    double margin = 1.0;  // relative change of the input that may change the answer
};

/// `planes`: planes that cannot hide (of x, and of the emitter). A triangle whose plane passes through an end within rounding cannot
/// either.
inline Visibility segment_visibility(const std::vector<Triangle>& triangles, const dvec3& x, const dvec3& y,
                                     std::initializer_list<int> planes) {
    Visibility out;
    double margin_hidden = 0.0;  // the clearest of the hits decides how certain "hidden" is
    for (const Triangle& triangle : triangles) {
        if (std::find(planes.begin(), planes.end(), triangle.plane) != planes.end()) continue;
        const Crossing from_x = cross_triangle(x, y - x, triangle), from_y = cross_triangle(y, x - y, triangle);
        const double between = std::min(from_x.t, 1.0 - from_x.t);  // > 0: the plane is met between the ends
        const double through = std::min(from_x.plane, from_y.plane) - tolerance::plane_through_centre;
        const double certainty = std::min({from_x.inside, from_y.inside, between, through});
        if (std::isnan(certainty)) continue;  // the segment lies in the triangle's plane
        if (certainty > 0.0) {
            out.visible = false;
            margin_hidden = std::max(margin_hidden, certainty);
        } else {
            out.margin = std::min(out.margin, -certainty);
        }
    }
    if (!out.visible) out.margin = margin_hidden;
    return out;
}

}  // namespace pencil::ref
