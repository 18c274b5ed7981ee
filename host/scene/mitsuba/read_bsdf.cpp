// A holder takes the name of its own element, or else that of the material inside.
#include "scene/mitsuba/read_bsdf.h"

#include <algorithm>

#include "scene/mitsuba/bsdf_plugins.h"
#include "scene/scene_file.h"
#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr int deepest_material = 16;  // materials that hold materials; a longer chain is a circle of references
constexpr std::size_t max_materials = std::size_t{1} << 18;

/// As Mitsuba reads them, too: flat places of such a map lean.
bool is_decoded_normal_map(const NestedObject& texture) {
    if (texture.type != "bitmap") return false;
    std::string file;
    for (const pugi::xml_node child : texture.node.children()) {
        const std::string name = child.attribute("name").value(), value = child.attribute("value").value();
        if ((name == "raw" && value == "true") || (name == "gamma" && parse_number(value) == 1.0)) return false;
        if (name == "filename") file = value;
    }
    const std::string extension = file.substr(std::min(file.rfind('.'), file.size()));
    return extension != ".exr" && extension != ".hdr" && extension != ".pfm";  // linear in any case
}

/// Of their own: light goes through.
bool has_two_sides(const SceneMaterial& m) {
    return m.model == MATERIAL_DIELECTRIC || m.model == MATERIAL_PASS || (m.model == MATERIAL_PRINCIPLED && m.principled.spec_trans > 0);
}

bool is_coating(const std::string& type) { return type == "coating" || type == "roughcoating"; }

}  // namespace

std::uint32_t BsdfReader::append(SceneMaterial material) {
    if (scene_.materials.size() >= max_materials)
        throw SceneError(shown(source_.file()), "the scene has more than " + std::to_string(max_materials) + " materials");
    scene_.materials.push_back(std::move(material));
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

std::uint32_t BsdfReader::index_of(pugi::xml_node node, int depth) {
    const auto place = indices_.find(node.hash_value());
    if (place != indices_.end()) return place->second;
    const std::uint32_t index = append(read(node, depth));
    indices_[node.hash_value()] = index;
    return index;
}

void BsdfReader::check(const std::vector<pugi::xml_node>& nodes) {
    const std::size_t materials = scene_.materials.size(), textures = scene_.textures.size();
    for (const pugi::xml_node node : nodes) read(node, 0);
    scene_.materials.resize(materials);
    scene_.textures.resize(textures);
}

/// How many blends lie within each other.
int BsdfReader::nesting(const SceneMaterial& material) {
    if (material.model != MATERIAL_BLEND) return 0;
    int deepest_inside = 0;
    for (const std::int64_t index : material.blended) {
        const auto place = nesting_.find(index);
        const int inside = place != nesting_.end() ? place->second : nesting(scene_.materials[static_cast<std::size_t>(index)]);
        nesting_[index] = inside;
        deepest_inside = std::max(deepest_inside, inside);
    }
    return deepest_inside + 1;
}

/// Changes the materials that scatter: the one, or those that it blends, which are copied for it.
void BsdfReader::change_leaves(SceneMaterial& material, const std::function<void(SceneMaterial&)>& change) {
    if (material.model == MATERIAL_PASS) return;
    if (material.model != MATERIAL_BLEND) return change(material);
    for (std::int64_t& index : material.blended) {
        SceneMaterial copy = scene_.materials[static_cast<std::size_t>(index)];
        if (copy.model == MATERIAL_PASS) continue;
        change_leaves(copy, change);
        index = append(std::move(copy));
    }
}

/// A material with a defect is grey; the defect is told at the end.
SceneMaterial BsdfReader::read(pugi::xml_node node, int depth) {
    const auto place = materials_.find(node.hash_value());
    if (place != materials_.end()) return place->second;
    SceneMaterial material;
    source_.problems().attempt([&] { material = read_new(node, depth); });
    return materials_[node.hash_value()] = material;
}

SceneMaterial BsdfReader::read_new(pugi::xml_node node, int depth) {
    Properties p(source_, node);
    if (depth > deepest_material) p.fail("", "refers to itself");
    const std::string type = node.attribute("type").value();
    const BsdfPlugin plugin = find_bsdf_plugin(type);
    SceneMaterial material = plugin ? plugin(p, textures_) : read_holder(p, type, depth);
    p.ignore({"specular_sampling_weight", "sample_visible", "ensure_energy_conservation"});
    if (nesting(material) > deepest_material)
        p.fail("", "holds more than " + std::to_string(deepest_material) + " blends within each other");
    if (node.attribute("id")) material.id = node.attribute("id").value();
    p.finish();
    return material;
}

SceneMaterial BsdfReader::read_holder(Properties& p, const std::string& type, int depth) {
    if (type == "twosided") return two_sided(p, depth);
    if (type == "mask") return mask(p, depth);
    if (type == "blendbsdf") return blend(p, depth);
    if (type == "mixturebsdf") return mixture(p, depth);
    if (type == "bumpmap" || type == "bump") return relief(p, true, depth);
    if (type == "normalmap") return relief(p, false, depth);
    return stand_in(p, depth);
}

/// Unknown plugins: the material inside, or else a diffuse one.
SceneMaterial BsdfReader::stand_in(Properties& p, int depth) {
    const std::vector<NestedObject> inner = p.take_objects("bsdf");
    if (inner.empty()) return read_unknown_bsdf(p, textures_);
    const std::string type = p.node().attribute("type").value();
    p.approximate("", "is not supported: the material inside is used alone");
    if (is_coating(type))
        p.ignore({"int_ior", "ext_ior", "thickness", "sigma_a", "alpha", "distribution", "specular_reflectance", "sample_visible"});
    return read(inner[0].node, depth + 1);
}

NestedObject BsdfReader::only_bsdf(Properties& p) {
    const std::vector<NestedObject> inner = p.take_objects("bsdf");
    if (inner.size() != 1) p.fail("", "needs exactly one nested bsdf");
    return inner[0];
}

std::uint32_t BsdfReader::pass() {
    if (!pass_) {
        SceneMaterial material;
        material.id = "null";
        material.model = MATERIAL_PASS;
        pass_ = append(std::move(material));
    }
    return *pass_;
}

SceneMaterial BsdfReader::two_sided(Properties& p, int depth) {
    const std::vector<NestedObject> inner = p.take_objects("bsdf");
    if (inner.empty() || inner.size() > 2) p.fail("", "needs exactly one nested bsdf, or two");
    for (const NestedObject& object : inner)
        if (object.type == "twosided" && object.node != p.node())
            source_.warn(object.named_at, p.label() + " holds another twosided, which adds nothing");
    SceneMaterial material = read(inner[0].node, depth + 1);
    if (has_two_sides(material)) {
        source_.warn(inner[0].named_at, p.label() + " changes nothing here: " + in_quotes(inner[0].type) + " has two sides of its own");
        return material;
    }
    change_leaves(material, [](SceneMaterial& leaf) { leaf.two_sided = !has_two_sides(leaf); });
    material.two_sided = true;
    if (inner.size() == 2) material.back = index_of(inner[1].node, depth + 1);
    return material;
}

SceneMaterial BsdfReader::mask(Properties& p, int depth) {
    const NestedObject inner = only_bsdf(p);
    const NumberSlot opacity = textures_.number(p, "opacity", 0.5);
    SceneMaterial material;
    const std::uint32_t covered = index_of(inner.node, depth + 1);
    material.blended[0] = pass();
    material.blended[1] = covered;
    material.id = scene_.materials[covered].id;
    material.model = MATERIAL_BLEND;
    material.weight = opacity.missing ? 1.0F : opacity.value;
    material.weight_texture = opacity.texture;
    return material;
}

SceneMaterial BsdfReader::blend(Properties& p, int depth) {
    const std::vector<NestedObject> inner = p.take_objects("bsdf");
    if (inner.size() != 2) p.fail("", "needs exactly two nested bsdfs");
    const NumberSlot weight = textures_.number(p, "weight", 0.5);
    SceneMaterial material;
    material.model = MATERIAL_BLEND;
    for (std::size_t i = 0; i < 2; ++i) material.blended[i] = index_of(inner[i].node, depth + 1);
    material.weight = weight.value;
    material.weight_texture = weight.texture;
    return material;
}

/// 0.x: any number of materials with weights, as a chain of blends.
SceneMaterial BsdfReader::mixture(Properties& p, int depth) {
    const std::vector<NestedObject> inner = p.take_objects("bsdf");
    const std::vector<double> weights = p.numbers("weights");
    if (inner.empty() || inner.size() != weights.size()) p.fail("weights", "needs as many weights as nested bsdfs");
    double total = 0;
    for (const double weight : weights)
        if (weight < 0) p.fail("weights", "weights must not be negative");
    for (const double weight : weights) total += weight;
    if (!(total > 0)) p.fail("weights", "one weight must be positive");
    if (total < 0.999 || total > 1.001) p.approximate("weights", "weights that do not add up to 1 are not supported: they are scaled");
    SceneMaterial material = read(inner[0].node, depth + 1);
    double sum = weights[0];
    for (std::size_t i = 1; i < inner.size(); ++i) {
        SceneMaterial next;
        next.model = MATERIAL_BLEND;
        next.blended[0] = append(material);
        next.blended[1] = index_of(inner[i].node, depth + 1);
        sum += weights[i];
        next.weight = static_cast<float>(sum > 0 ? weights[i] / sum : 0);
        material = next;
    }
    return material;
}

SceneMaterial BsdfReader::relief(Properties& p, bool bump, int depth) {
    const NestedObject inner = only_bsdf(p);
    const std::vector<NestedObject> maps = p.take_objects("texture");
    if (maps.size() != 1) p.fail("", "needs exactly one nested texture");
    const ColourSlot slot =
        textures_.read(maps[0], ColourUse::coefficient, bump ? TextureUse::Channel::luminance : TextureUse::Channel::all);
    if (!bump && is_decoded_normal_map(maps[0]))
        source_.warn(maps[0].named_at,
                     p.label() + ": the map's normals are decoded by the sRGB curve, as in Mitsuba; \"raw\" should be true");
    const float scale = static_cast<float>(p.number("scale", 1)) * slot.value.y;
    SceneMaterial material = read(inner.node, depth + 1);
    if (slot.texture == no_texture) return material;  // flat
    change_leaves(material, [&](SceneMaterial& leaf) {
        if (leaf.normal_texture != no_texture) p.approximate("", "relief on relief is not supported: the inner one is left out");
        leaf.normal_texture = slot.texture;
        leaf.bump = bump;
        leaf.bump_scale = bump ? scale : 1.0F;
    });
    return material;
}

}  // namespace pencil
