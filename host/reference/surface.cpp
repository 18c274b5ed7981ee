#include "reference/surface.h"

#include "scene/texture_lookup.h"

namespace pencil {
namespace {

glm::vec3 to_viewer(const ShadingFrame& frame, const glm::vec3& direction) { return -glm::normalize(frame.to_local(direction)); }

/// Frame on the side that was hit, with the shading normal turned by the relief if there is one (Mitsuba's normalmap and bumpmap).
ShadingFrame shading_frame(const RayScene& scene, const RayHit& hit, const SurfaceSide& side, const TexturePoint& point) {
    if (!side.tangents) return ShadingFrame(hit.shading);
    if (!side.relief || point.dp_du == glm::vec3(0.0F)) return {hit.shading, point.dp_du};
    const float front = hit.front ? 1.0F : -1.0F;
    const Texture& texture = scene.surfaces().texture(side.source->normal_texture);
    const glm::vec3 n = front * hit.shading;
    glm::vec3 turned;
    if (side.source->bump) {
        // Heights are lengths of the world.
        const glm::vec2 slope = look_up_slope(texture, point.uv) * (side.source->bump_scale / static_cast<float>(scene.scale()));
        const glm::vec3 dp_du = point.dp_du + (slope.x - glm::dot(n, point.dp_du)) * n,
                        dp_dv = point.dp_dv + (slope.y - glm::dot(n, point.dp_dv)) * n;
        turned = glm::cross(dp_du, dp_dv);
        if (glm::dot(turned, front * hit.normal) < 0.0F) turned = -turned;
    } else {
        glm::vec3 local = 2.0F * glm::vec3(look_up(texture, point.uv, point.colour)) - 1.0F;
        const bool along_v = glm::dot(glm::cross(n, point.dp_du), point.dp_dv) > 0.0F;
        if (side.source->y_against_v && along_v) local.y = -local.y;
        turned = ShadingFrame(n, point.dp_du).to_world(local);
    }
    if (!(glm::dot(turned, turned) > 0.0F)) return {hit.shading, point.dp_du};
    return {front * glm::normalize(turned), point.dp_du};
}

const SurfaceSide& side_of(const RayScene& scene, const RayHit& hit) {
    return scene.surfaces().side(SurfaceTable::number(hit.material, hit.front));
}

TexturePoint point_for(const RayScene& scene, const RayHit& hit, const SurfaceSide& side) {
    return side.textured || side.tangents || side.blend() ? scene.texture_point(hit) : TexturePoint{};
}

/// A blend has no frame of its own unless it has a relief, which then is that of both.
const SurfaceSide& framed(const SurfaceSide& blend, const SurfaceSide& leaf) { return leaf.relief || !blend.relief ? leaf : blend; }

glm::vec3 transmittance_of(const RayScene& scene, const RayHit& hit, const SurfaceSide& side, const SurfaceSide& top,
                           const TexturePoint& point, const glm::vec3& direction) {
    if (!side.may_pass) return glm::vec3(0.0F);
    const SurfaceTable& table = scene.surfaces();
    if (side.blend()) {
        const float second = table.blend_weight(side, point);
        glm::vec3 sum(0.0F);
        for (int k = 0; k < 2; ++k) {
            const float weight = k == 1 ? second : 1.0F - second;
            if (weight > 0.0F) sum += weight * transmittance_of(scene, hit, table.side(side.blended[k]), top, point, direction);
        }
        return sum;
    }
    if (side.material.model == MATERIAL_PASS) return glm::vec3(1.0F);
    const SurfaceMaterial material = side.textured ? table.at(side, point) : side.material;
    glm::vec3 omega_o = to_viewer(shading_frame(scene, hit, framed(top, side), point), direction);
    if (!(omega_o.z > 0.0F)) omega_o = to_viewer(ShadingFrame(hit.normal), direction);
    return straight_transmittance(material, omega_o);
}

}  // namespace

ScatteringSurface::ScatteringSurface(const RayScene& scene, const RayHit& hit, const glm::vec3& direction, Sampler& sampler)
    : hit_(hit), frame_(hit.shading) {
    const SurfaceTable& table = scene.surfaces();
    const SurfaceSide &top = side_of(scene, hit), *side = &top;
    const TexturePoint point = point_for(scene, hit, top);
    while (side->blend())
        side = &table.side(side->blended[sampler.next_1d() < static_cast<double>(table.blend_weight(*side, point)) ? 1 : 0]);
    material_ = side->textured ? table.at(*side, point) : side->material;
    absorbs_ = material_.absorbs;
    const SurfaceSide& shape = framed(top, *side);
    frame_ = shading_frame(scene, hit, shape, point);
    omega_o_ = to_viewer(frame_, direction);
    if (omega_o_.z > 0.0F || material_.model == MATERIAL_PASS || (material_.model == MATERIAL_DIFFUSE && !shape.relief)) return;
    // The shading normal looks away from the viewer. Facets of a relief are dark there, as Mitsuba's; interpolated normals and glass are
    // given up for the true normal, or the rims of spheres would be black.
    if (shape.relief && !material_.transmits()) {
        absorbs_ = true;
        return;
    }
    frame_ = ShadingFrame(hit.normal);
    omega_o_ = to_viewer(frame_, direction);
}

glm::vec3 straight_transmittance(const RayScene& scene, const RayHit& hit, const glm::vec3& direction) {
    const SurfaceSide& side = side_of(scene, hit);
    if (!side.may_pass) return glm::vec3(0.0F);
    return transmittance_of(scene, hit, side, side, point_for(scene, hit, side), direction);
}

}  // namespace pencil
