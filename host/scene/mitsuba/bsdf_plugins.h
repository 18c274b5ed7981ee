// Mitsuba's scattering models that hold no other: each reads its parameters into one material.
#pragma once

#include "scene/mitsuba/read_texture.h"

namespace pencil {

/// What a reader of a material needs beside its parameters.
using BsdfPlugin = SceneMaterial (*)(Properties& p, TextureReader& textures);

/// Null for plugins that are not in the table.
BsdfPlugin find_bsdf_plugin(const std::string& type);

SceneMaterial read_diffuse(Properties& p, TextureReader& textures);
SceneMaterial read_rough_diffuse(Properties& p, TextureReader& textures);
SceneMaterial read_null(Properties& p, TextureReader& textures);
SceneMaterial read_conductor(Properties& p, TextureReader& textures);
SceneMaterial read_rough_conductor(Properties& p, TextureReader& textures);
SceneMaterial read_dielectric(Properties& p, TextureReader& textures);
SceneMaterial read_thin_dielectric(Properties& p, TextureReader& textures);
SceneMaterial read_rough_dielectric(Properties& p, TextureReader& textures);
SceneMaterial read_plastic(Properties& p, TextureReader& textures);
SceneMaterial read_rough_plastic(Properties& p, TextureReader& textures);
SceneMaterial read_phong(Properties& p, TextureReader& textures);
SceneMaterial read_ward(Properties& p, TextureReader& textures);
SceneMaterial read_principled(Properties& p, TextureReader& textures);
SceneMaterial read_principled_thin(Properties& p, TextureReader& textures);
/// Grey, or of the colour that the plugin has under a usual name; a warning.
SceneMaterial read_unknown_bsdf(Properties& p, TextureReader& textures);

// Parameters that several of them have.

void read_albedo(Properties& p, TextureReader& textures, const std::string& name, SceneMaterial& material);
/// "specular_reflectance"; absent: 1.
void read_specular(Properties& p, TextureReader& textures, SceneMaterial& material, float absent = 1.0F);
/// "alpha", or "alpha_u" and "alpha_v", and "distribution".
void read_roughness(Properties& p, TextureReader& textures, SceneMaterial& material);
/// An index of refraction, by number or name.
double read_index(Properties& p, const std::string& name, const std::string& absent);
/// "int_ior" over "ext_ior".
void read_eta(Properties& p, const std::string& inside, SceneMaterial& material);

}  // namespace pencil
