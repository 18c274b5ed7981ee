// Film pencils on their lattice of pixels in double precision: which of them a surfel may use, their smoothing, and what they say at a
// surfel. Written from docs/overview.md ("The surface method") and the docstrings of the launchers.
#pragma once

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "reference/surface_pencil_ref.h"

namespace pencil::ref {

/// Pencils by pixel of a film; spacings are powers of two.
struct Lattice {
    const std::vector<SurfacePencil>& pencils;
    const std::vector<int>& at;  // by pixel, -1: none
    int width, height, coarsest, finest;
};

/// A pencil that a pixel may use: that of a corner of its cell at one spacing.
struct Corner {
    int pencil;
    double tent;  // 1 at the corner, 0 one spacing away along either axis
};

/// Pencils at the corners of the cells of (x, y), coarsest spacing first. Corners beyond the film are moved to its last row or column. A
/// corner that is one of the next coarser spacing too counts there only.
inline std::vector<Corner> corners_about(const Lattice& lattice, int x, int y) {
    std::vector<Corner> out;
    for (int spacing = lattice.coarsest; spacing >= lattice.finest; spacing /= 2)
        for (const int below : {0, 1})
            for (const int right : {0, 1}) {
                const int cx = std::min((x / spacing + right) * spacing, lattice.width - 1);
                const int cy = std::min((y / spacing + below) * spacing, lattice.height - 1);
                const bool coarser = cx % (2 * spacing) == 0 && cy % (2 * spacing) == 0;
                const int pencil = lattice.at[static_cast<std::size_t>(cy * lattice.width + cx)];
                if (pencil < 0 || (spacing < lattice.coarsest && coarser)) continue;
                const auto tent = [&](int apart) { return std::max(1.0 - std::abs(apart) / static_cast<double>(spacing), 0.0); };
                out.push_back({pencil, tent(cx - x) * tent(cy - y)});
            }
    return out;
}

struct Cover {
    double least = infinite;  // reuse error of the best pencil
    double margin = 1.0;      // relative distance from the nearest decision
};

/// Lines of a lattice lie at 0, spacing, 2 spacing .. and at size - 1. The one that is `steps` away from that at `from`; -1: there is none.
inline int line_away(int from, int steps, int spacing, int size) {
    std::vector<int> lines;
    for (int at = 0; at < size - 1; at += spacing) lines.push_back(at);
    lines.push_back(size - 1);
    const auto place = std::find(lines.begin(), lines.end(), from) - lines.begin() + steps;
    return place >= 0 && place < static_cast<std::ptrdiff_t>(lines.size()) ? lines[static_cast<std::size_t>(place)] : -1;
}

/// How well the lattice covers a surfel of pixel (px, py).
inline Cover cover(const Lattice& lattice, int px, int py, const dvec3& x, const dvec3& n) {
    Cover out;
    for (const Corner& corner : corners_about(lattice, px, py)) {
        const Reuse r = reuse(lattice.pencils[static_cast<std::size_t>(corner.pencil)], x, n);
        out.margin = std::min(out.margin, r.margin);
        out.least = std::min(out.least, r.error);
    }
    return out;
}

/// A linear function of position about a pencil, and how well its data determine it.
struct Fit {
    dvec3 value{0.0}, along_t{0.0}, along_b{0.0};
    double margin = 1.0;
};

constexpr int smooth_reach = 3;      // neighbours to each side
constexpr double slope_tiny = 1e-6;  // least distance that neighbours count as, share of the pencil's own mean distance
constexpr double slope_hold = 1e-3;  // share of the neighbours' second moment that holds slopes at 0

/// The function v + a s + b u, (s, u) along the tangents, that minimises sum w (E - v - a s - b u)^2 + hold (a^2 + b^2) over the pencils
/// up to three spacings away on the pencil's own lattice. A neighbour's weight falls from 1 to 0 as the mean of the two reuse errors, of
/// each for the other's place, grows to most_error. The value is not below 0.
inline Fit fit(const Lattice& lattice, const std::vector<float4>& irradiance, int px, int py, double most_error) {
    const int own_index = lattice.at[static_cast<std::size_t>(py * lattice.width + px)];
    const SurfacePencil& own = lattice.pencils[static_cast<std::size_t>(own_index)];
    const dvec3 x = xyz(own.position), n = xyz(own.normal);
    const TangentFrame frame(n);
    struct Sample {
        double weight;
        dvec3 row, value;
    };
    std::vector<Sample> samples;
    Fit out;
    for (int dy = -smooth_reach; dy <= smooth_reach; ++dy)
        for (int dx = -smooth_reach; dx <= smooth_reach; ++dx) {
            const int qx = line_away(px, dx, own.spacing, lattice.width), qy = line_away(py, dy, own.spacing, lattice.height);
            if (qx < 0 || qy < 0) continue;
            const int index = lattice.at[static_cast<std::size_t>(qy * lattice.width + qx)];
            if (index < 0) continue;
            const SurfacePencil& p = lattice.pencils[static_cast<std::size_t>(index)];
            const Reuse r = reuse(p, x, n);
            if (index != own_index) out.margin = std::min(out.margin, r.margin);
            if (r.distance == infinite) continue;
            const double error = 0.5 * (r.error + reuse_error(own, r.distance, n));
            const dvec3 step = xyz(p.position) - x;
            samples.push_back({std::max(1.0 - error / most_error, 0.0),
                               {1.0, glm::dot(step, frame.t), glm::dot(step, frame.b)},
                               xyz(irradiance[static_cast<std::size_t>(index)])});
        }
    // Normal equations; the hold is a share of the moments about the weighted mean.
    glm::dmat3 moments(0.0), right(0.0);
    for (const Sample& s : samples) {
        moments += s.weight * glm::outerProduct(s.row, s.row);
        right += s.weight * glm::outerProduct(s.value, s.row);  // column k: sum of w row_k E
    }
    const double w = moments[0][0];
    const double spread = moments[1][1] - moments[0][1] * moments[0][1] / w + moments[2][2] - moments[0][2] * moments[0][2] / w;
    const double tiny = std::max(no_step(x), slope_tiny * static_cast<double>(own.facing.w));
    const double hold = slope_hold * spread + w * tiny * tiny;
    moments[1][1] += hold;
    moments[2][2] += hold;
    const glm::dmat3 solution = right * glm::inverse(moments);
    out.value = glm::max(solution[0], dvec3(0));
    out.along_t = solution[1];
    out.along_b = solution[2];
    return out;
}

struct Projected {
    dvec3 irradiance{0.0};
    double margin = 1.0;
};

constexpr double least_error_share = 0.02;  // errors below this share of the greatest count alike
constexpr double unlike_turn = 0.25;        // of 1 - cos against squared distances, in terms of that to the eye, where no pencil reaches

/// Irradiance at a surfel of pixel (px, py): the mean of what the fits of its corners' pencils say there, weighted by tent and by
/// 1/error - 1/most_error; where none reaches, the value of the most similar pencil; 0 where there are no pencils. fits: three per pencil.
inline Projected project(const Lattice& lattice, const std::vector<float4>& fits, int px, int py, const dvec3& x, const dvec3& n,
                         double most_error) {
    Projected out;
    dvec3 sum(0), most_alike(0);
    double weights = 0, unlike = infinite, next_unlike = infinite;
    for (const Corner& corner : corners_about(lattice, px, py)) {
        const auto index = static_cast<std::size_t>(corner.pencil);
        const SurfacePencil& p = lattice.pencils[index];
        const dvec3 step = x - xyz(p.position);
        const TangentFrame frame(xyz(p.normal));
        const Reuse r = reuse(p, x, n);
        out.margin = std::min(out.margin, r.margin);
        const double error = std::max(r.error, least_error_share * most_error);
        const double weight = std::max(1 / error - 1 / most_error, 0.0) * corner.tent;
        const dvec3 there =
            xyz(fits[3 * index]) + glm::dot(step, frame.t) * xyz(fits[3 * index + 1]) + glm::dot(step, frame.b) * xyz(fits[3 * index + 2]);
        sum += weight * glm::max(there, dvec3(0));
        weights += weight;
        const double difference = glm::dot(step, step) + unlike_turn * (1.0 - glm::dot(xyz(p.normal), n)) * glm::dot(x, x);
        if (difference < unlike) {
            next_unlike = unlike;
            unlike = difference;
            most_alike = xyz(fits[3 * index]);
        } else if (difference > unlike) {
            next_unlike = std::min(next_unlike, difference);
        }
    }
    out.irradiance = weights > 0 ? sum / weights : most_alike;
    if (weights <= 0 && unlike < infinite) out.margin = std::min(out.margin, next_unlike / unlike - 1.0);
    return out;
}

}  // namespace pencil::ref
