// Next-event estimation and BSDF sampling, combined by the power heuristic (Veach 1997, 9.2). Surfaces that light passes unturned are no
// vertices of a path: both kinds of sample go through them, and the densities are those of the direction from the last vertex.
#include "reference/path.h"

#include <algorithm>
#include <cmath>

#include "reference/surface.h"

namespace pencil {
namespace {

/// Paths shorter than this are not ended at random: they carry most of the light.
constexpr int sure_depth = 4;
/// Where nothing is lost paths would never end.
constexpr int longest_path = 1 << 16;

float power_heuristic(float density, float other) {
    const float ratio = other / density;
    return 1.0F / (1.0F + ratio * ratio);
}

/// The hit point, moved to the side of `normal` further than its rounding error.
glm::vec3 off_surface(const glm::vec3& point, const glm::vec3& normal, float offset) { return point + offset * normal; }

void record(PathSums& sums, int order, const glm::vec3& radiance) {
    if (!(std::abs(radiance.x) + std::abs(radiance.y) + std::abs(radiance.z) <= std::numeric_limits<float>::max())) {
        ++sums.dropped;
        return;
    }
    const int slot = std::min(order, most_orders - 1);
    sums.radiance[static_cast<std::size_t>(slot)] += radiance;
    sums.orders = std::max(sums.orders, slot + 1);
}

template <typename Surface>
void see(SurfaceSums* seen, const Surface& surface, const RayHit& hit, float weight) {
    seen->albedo += weight * surface.albedo();
    seen->normal += weight * surface.normal();
    seen->position += weight * hit.point;
    seen->weight += weight;
}

}  // namespace

/// Share of light that comes along a shadow ray.
template <typename Surface>
glm::vec3 PathIntegrator::transmittance(const Ray& ray, PathSums& sums) const {
    ++sums.rays;
    if (Surface::plain || !scene_.surfaces().may_pass()) return glm::vec3(scene_.occluded(ray) ? 0.0F : 1.0F);
    const bool endless = ray.length > 1.0F;
    const glm::vec3 end = ray.origin + ray.direction;
    glm::vec3 share(1.0F);
    Ray rest = ray;
    RayHit hit;
    for (int i = 0; i < longest_path && scene_.intersect(rest, hit); ++i, ++sums.rays) {
        share *= straight_transmittance(scene_, hit, rest.direction);
        if (share == glm::vec3(0.0F)) return share;
        rest.origin = off_surface(hit.point, -hit.normal, hit.offset);
        if (endless) continue;
        const glm::vec3 left = end - rest.origin;
        if (!(glm::dot(left, rest.direction) > 0.0F)) break;  // the end lay just behind the surface
        rest.direction = left;
    }
    return share;
}

/// Radiance that the surface at `hit` scatters of one light sample. `Surface`: those of the scene.
template <typename Surface, typename Vertex>
glm::vec3 PathIntegrator::direct_light(const RayHit& hit, const Vertex& surface, const glm::dvec2& u, PathSums& sums) const {
    const EmitterSample light = emitters_.sample(u, hit.point);
    const glm::vec3 segment = light.far_away ? light.point : light.point - hit.point;
    const float square = light.far_away ? 1.0F : glm::dot(segment, segment), inverse = 1.0F / std::sqrt(square);
    const glm::vec3 omega_i = surface.to_local(segment) * inverse;
    if (!surface.faces(omega_i, segment)) return glm::vec3(0.0F);
    glm::vec3 radiance = light.emitted * (1.0F / (light.density * square)) * surface.evaluate(omega_i);
    if (!light.one_point) {
        const float light_cosine = light.far_away ? 1.0F : -glm::dot(light.normal, segment) * inverse;
        if (!(light_cosine > 0.0F)) return glm::vec3(0.0F);
        radiance *= light_cosine * power_heuristic(light.density * square, surface.pdf(omega_i) * light_cosine);
    }
    if (radiance == glm::vec3(0.0F)) return radiance;
    const float side = Vertex::plain || omega_i.z > 0.0F ? hit.offset : -hit.offset;
    const glm::vec3 from = off_surface(hit.point, hit.normal, side);
    if (light.far_away) return radiance * transmittance<Surface>({from, segment}, sums);
    const glm::vec3 to = off_surface(light.point, light.normal, light.offset);
    return radiance * transmittance<Surface>({from, to - from, 1.0F}, sums);
}

template <typename Surface>
void PathIntegrator::trace_among(const Start& start, float weight, Sampler& sampler, PathSums& sums, SurfaceSums* seen) const {
    Ray ray = start.ray;
    RayHit hit;
    glm::vec3 throughput(1.0F);
    float density = start.density;  // per solid angle, with which the BSDF chose the ray; 0: light sampling had no part in it
    float travelled = 0;            // since the last vertex, to the beginning of the ray
    float compression = 1;          // of radiance in media that the path is in: no reason to end it
    bool met = start.inside && scene_.intersect(ray, hit);
    sums.rays += 1;
    for (int depth = start.depth, passed = 0;;) {
        if (!met) {
            const EnvironmentLight* environment = emitters_.environment();
            if (environment == nullptr) return;
            const glm::vec3 direction = glm::normalize(ray.direction);
            const float share = density > 0.0F ? power_heuristic(density, emitters_.environment_density(direction)) : 1.0F;
            record(sums, depth - 1, weight * share * throughput * environment->radiance(direction));
            return;
        }
        const SurfaceEmission& emission = scene_.emission()[hit.shape];
        if (hit.front && emission.light_density > 0.0F) {
            float share = 1.0F;
            if (density > 0.0F) {
                const float speed = glm::length(ray.direction), length = travelled + speed * hit.distance,
                            cosine = -glm::dot(hit.normal, ray.direction) / speed;
                share = power_heuristic(density, emission.light_density * length * length / cosine);
            }
            const glm::vec3 radiance = Surface::plain ? emission.radiance : scene_.emitted(hit.triangle, hit.u, hit.v);
            record(sums, depth - 1, weight * share * throughput * radiance);
        }
        const Surface surface(scene_, hit, ray.direction, sampler);
        if (seen != nullptr && depth == 1 && !surface.may_pass()) see(seen, surface, hit, weight);
        const bool last = depth == max_depth_;
        if (surface.absorbs() || (last && !surface.may_pass())) return;
        const glm::dvec2 light_u = sampler.next_2d(), bsdf_u = sampler.next_2d();
        if (!last && !emitters_.empty() && !surface.only_delta())
            record(sums, depth, weight * throughput * direct_light<Surface>(hit, surface, light_u, sums));

        const BsdfSample chosen = surface.sample(bsdf_u, sampler);
        if (!(chosen.pdf > 0.0F)) return;
        throughput *= chosen.weight;
        if (!Surface::plain && chosen.passes) {
            if (++passed == longest_path) return;
            travelled += glm::length(ray.direction) * hit.distance;
            ray = {off_surface(hit.point, -hit.normal, hit.offset), ray.direction};
        } else {
            if (!Surface::plain && seen != nullptr && depth == 1 && surface.may_pass()) see(seen, surface, hit, weight);
            const glm::vec3 direction = surface.to_world(chosen.omega_i);
            if (last || !surface.faces(chosen.omega_i, direction)) return;
            density = !Surface::plain && chosen.delta ? 0.0F : chosen.pdf;
            travelled = 0;
            compression *= chosen.eta * chosen.eta;
            if (depth >= sure_depth) {
                // No cap below 1: dividing by less than was lost makes weights grow without bound, and their variance.
                const float survival = std::min(std::max({throughput.x, throughput.y, throughput.z}) * compression, 1.0F);
                if (!(sampler.next_1d() < survival)) return;
                throughput /= survival;
                if (depth == longest_path) {
                    ++sums.cut;
                    return;
                }
            }
            ++depth;
            const float side = Surface::plain || chosen.omega_i.z > 0.0F ? hit.offset : -hit.offset;
            ray = {off_surface(hit.point, hit.normal, side), direction};
        }
        ++sums.rays;
        met = scene_.intersect(ray, hit);
    }
}

template <typename Surface>
void PathIntegrator::receive(const RayHit& at, float weight, Sampler& sampler, PathSums& sums) const {
    const glm::dvec2 light_u = sampler.next_2d(), direction_u = sampler.next_2d();
    if (max_depth_ == 1) return;
    const WhiteReceiver receiver(at);
    if (!emitters_.empty()) record(sums, 1, weight * direct_light<Surface>(at, receiver, light_u, sums));
    const glm::vec3 omega_i = cosine_direction(direction_u), direction = receiver.to_world(omega_i);
    if (!receiver.faces(omega_i, direction)) return;
    const Ray ray{off_surface(at.point, at.normal, at.offset), direction};
    trace_among<Surface>({ray, true, 2, receiver.pdf(omega_i)}, weight, sampler, sums, nullptr);
}

void PathIntegrator::trace_receiver(const RayHit& at, float weight, Sampler& sampler, PathSums& sums) const {
    if (scene_.surfaces().plain())
        receive<DiffuseSurface>(at, weight, sampler, sums);
    else
        receive<ScatteringSurface>(at, weight, sampler, sums);
}

void PathIntegrator::trace_received(const Ray& camera_ray, bool inside, float weight, Sampler& sampler, PathSums& sums) const {
    RayHit hit;
    ++sums.rays;
    if (!inside || !scene_.intersect(camera_ray, hit)) return;
    if (scene_.surfaces().has_relief(SurfaceTable::number(hit.material, hit.front))) hit.shading = hit.normal;
    trace_receiver(hit, weight, sampler, sums);
}

void PathIntegrator::trace(const Ray& camera_ray, bool inside, float weight, Sampler& sampler, PathSums& sums, SurfaceSums* seen) const {
    if (scene_.surfaces().plain())
        trace_among<DiffuseSurface>({camera_ray, inside}, weight, sampler, sums, seen);
    else
        trace_among<ScatteringSurface>({camera_ray, inside}, weight, sampler, sums, seen);
}

}  // namespace pencil
