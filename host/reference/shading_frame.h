// Right-handed orthonormal frames about a shading normal.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace pencil {

class ShadingFrame {
public:
    /// Any frame about a unit normal (Duff et al. 2017).
    explicit ShadingFrame(const glm::vec3& n) : normal_(n) {
        const float sign = std::copysign(1.0F, n.z), a = -1.0F / (sign + n.z), b = n.x * n.y * a;
        tangent_ = glm::vec3(1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x);
        bitangent_ = glm::vec3(b, sign + n.y * n.y * a, -n.y);
    }
    /// With x along the part of `along` that is tangent; any frame where there is none.
    ShadingFrame(const glm::vec3& n, const glm::vec3& along) : ShadingFrame(n) {
        const glm::vec3 t = along - glm::dot(n, along) * n;
        const float square = glm::dot(t, t);
        if (!(square > 1e-12F * glm::dot(along, along))) return;
        tangent_ = t / std::sqrt(square);
        tangent_ = glm::normalize(tangent_ - glm::dot(n, tangent_) * n);  // once more, for what cancelled
        bitangent_ = glm::cross(n, tangent_);
    }

    glm::vec3 to_world(const glm::vec3& v) const { return v.x * tangent_ + v.y * bitangent_ + v.z * normal_; }
    glm::vec3 to_local(const glm::vec3& v) const { return {glm::dot(tangent_, v), glm::dot(bitangent_, v), glm::dot(normal_, v)}; }
    const glm::vec3& normal() const { return normal_; }

private:
    glm::vec3 tangent_, bitangent_, normal_;
};

}  // namespace pencil
