// How the chains of a surfel of the film are shared out: those that draw along its lobes, and those for what its base scatters otherwise than evenly.

#include "lib/bsdf.cl"
#include "lib/colour.cl"
#include "lib/hemisphere.cl"
#include "lib/surfel.cl"

/// Share of the chains of a surfel of the film for what its base scatters otherwise than evenly, beside that for lobes.
#define CHAIN_UNEVEN 0.25f

/// True of models whose bases look at where light comes from.
static inline bool base_is_uneven(int model) {
    return model == MATERIAL_PLASTIC || model == MATERIAL_PRINCIPLED || model == MATERIAL_ROUGH_DIFFUSE;
}

/// Of the chains of a surfel, whose lobes scatter this share, the first so many are for its base.
static inline int chains_for_base(const Vertex *v, float lobes, int chains) {
    float base = base_is_uneven(v->bsdf.model) ? CHAIN_UNEVEN * largest(v->albedo) : 0.0f;
    if (!(base > 0.0f)) return 0;
    return lobes > 0.0f ? clamp((int)(base / (base + lobes) * chains + 0.5f), min(1, chains - 1), chains - 1) : chains;
}

/// The rest, which draw directions by the density of the lobes.
static inline int chains_along_lobes(const Vertex *v, float3 factor, int chains) {
    return chains - chains_for_base(v, largest(bsdf_share(&v->bsdf, seen_from(v->n, v->o)) * factor), chains);
}
