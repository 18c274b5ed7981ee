// How much light a rough varnish lets through, by roughness and angle: what its microfacets do not reflect.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace pencil {

struct VarnishTable {
    int first;     // texel
    float alpha;   // of the first row
    float by_row;  // rows for each unit of alpha, 0: there is one roughness only
};

/// Appends rows of VARNISH_COLUMNS texels (shared/material.h) about the varnish of a plastic.
VarnishTable add_varnish_table(const SceneMaterial& material, std::vector<std::uint64_t>& texels);

}  // namespace pencil
