// A map is interpolated between four texels, in cells. A cell is chosen by the mean of its corners' luminance times its solid angle, and a
// direction in it evenly: a density that is exact, has no singular poles, and is nowhere 0 where there is light.
#include "reference/environment_light.h"

#include <algorithm>
#include <cmath>

#include "scene/light_unit.h"
#include "util/constants.h"

namespace pencil {
namespace {

double luminance(const glm::vec3& c) { return 0.212671 * c.x + 0.715160 * c.y + 0.072169 * c.z; }
double mean(const glm::vec3& c) { return (static_cast<double>(c.x) + c.y + c.z) / 3; }

glm::dvec3 direction_at(double cosine, double phi) {
    const double sine = std::sqrt(std::max(1 - cosine * cosine, 0.0));
    return {sine * std::sin(phi), cosine, -sine * std::cos(phi)};
}

}  // namespace

EnvironmentLight::EnvironmentLight(const Environment& environment, double light)
    : environment_(environment), radiance_(in_light_unit(environment.radiance, light)), to_local_(glm::inverse(environment.to_world)) {
    flux_ = 4 * pi * mean(radiance_);
    if (!environment.is_map()) return;
    rows_ = std::max(environment.height - 1, 1);
    flux_ = 0;
    double total = 0;
    for (int y = 0; y < rows_; ++y) {
        const double angle = 2 * pi / environment.width * (std::cos(pi * y / rows_) - std::cos(pi * (y + 1) / rows_));
        double row = 0;
        std::vector<double> sums;
        for (int x = 0; x < environment.width; ++x) {
            const glm::vec3 centre = 0.25F * (texel(x, y) + texel(x + 1, y) + texel(x, y + 1) + texel(x + 1, y + 1));
            flux_ += angle * mean(centre * radiance_);
            sums.push_back(row += luminance(centre * radiance_));
        }
        for (int x = 0; x < environment.width; ++x) {
            const double part = row > 0 ? sums[static_cast<std::size_t>(x)] / row : (x + 1.0) / environment.width;
            cumulative_.push_back(static_cast<float>(part));
        }
        rows_up_to_.push_back(total += row * angle);
    }
    for (double& value : rows_up_to_) value = total > 0 ? value / total : 0;
}

const glm::vec3& EnvironmentLight::texel(int x, int y) const {
    const int column = x % environment_.width, row = std::min(y, environment_.height - 1);
    return environment_
        .texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(environment_.width) + static_cast<std::size_t>(column)];
}

/// Columns of texels have their centres at odd halves, rows begin and end at the poles.
EnvironmentLight::Place EnvironmentLight::place(const glm::dvec3& local) const {
    const double u = std::atan2(local.x, -local.z) / (2 * pi), v = std::acos(std::clamp(local.y, -1.0, 1.0)) / pi;
    double x = u * environment_.width - 0.5;
    x -= std::floor(x / environment_.width) * environment_.width;
    const double y = v * rows_;
    const int column = std::min(static_cast<int>(x), environment_.width - 1), row = std::min(static_cast<int>(y), rows_ - 1);
    return {column, row, x - column, y - row};
}

glm::vec3 EnvironmentLight::value(const Place& p) const {
    const auto s = static_cast<float>(p.s), t = static_cast<float>(p.t);
    const glm::vec3 above = glm::mix(texel(p.x, p.y), texel(p.x + 1, p.y), s),
                    below = glm::mix(texel(p.x, p.y + 1), texel(p.x + 1, p.y + 1), s);
    return radiance_ * glm::mix(above, below, t);
}

float EnvironmentLight::cell_density(int x, int y) const {
    const auto row = static_cast<std::size_t>(y), cell = row * static_cast<std::size_t>(environment_.width) + static_cast<std::size_t>(x);
    const double column = cumulative_[cell] - (x > 0 ? cumulative_[cell - 1] : 0.0F);
    const double angle = 2 * pi / environment_.width * (std::cos(pi * y / rows_) - std::cos(pi * (y + 1) / rows_));
    return static_cast<float>((rows_up_to_[row] - (y > 0 ? rows_up_to_[row - 1] : 0.0)) * column / angle);
}

EnvironmentLight::Sample EnvironmentLight::sample(const glm::dvec2& u) const {
    if (!environment_.is_map()) return {glm::vec3(direction_at(1 - 2 * u.x, 2 * pi * u.y)), radiance_, static_cast<float>(0.25 / pi)};
    const auto row = std::upper_bound(rows_up_to_.begin(), rows_up_to_.end() - 1, u.x);
    const auto y = static_cast<int>(row - rows_up_to_.begin());
    const double low = y > 0 ? *(row - 1) : 0.0, t = *row > low ? std::clamp((u.x - low) / (*row - low), 0.0, 1.0) : 0.5;
    const auto begin = cumulative_.begin() + static_cast<std::ptrdiff_t>(y) * environment_.width, end = begin + environment_.width;
    const auto cell = std::upper_bound(begin, end - 1, u.y, [](double value, float c) { return value < static_cast<double>(c); });
    const auto x = static_cast<int>(cell - begin);
    const double left = x > 0 ? static_cast<double>(*(cell - 1)) : 0.0, right = *cell;
    const double s = right > left ? std::clamp((u.y - left) / (right - left), 0.0, 1.0) : 0.5;
    // Evenly in the cell: by the cosine of the polar angle.
    const double top = std::cos(pi * y / rows_), bottom = std::cos(pi * (y + 1) / rows_), cosine = top + t * (bottom - top);
    const glm::dvec3 local = direction_at(cosine, 2 * pi * (x + s + 0.5) / environment_.width);
    const Place p{x, y, s, std::acos(std::clamp(cosine, -1.0, 1.0)) / pi * rows_ - y};
    return {glm::vec3(glm::normalize(environment_.to_world * local)), value(p), cell_density(x, y)};
}

glm::vec3 EnvironmentLight::radiance(const glm::vec3& direction) const {
    if (!environment_.is_map()) return radiance_;
    return value(place(glm::normalize(to_local_ * glm::dvec3(direction))));
}

float EnvironmentLight::density(const glm::vec3& direction) const {
    if (!environment_.is_map()) return static_cast<float>(0.25 / pi);
    const Place p = place(glm::normalize(to_local_ * glm::dvec3(direction)));
    return cell_density(p.x, p.y);
}

}  // namespace pencil
