// What a render can be asked for. These are the program's defaults and the library's: there are no others.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "options/layer.h"
#include "options/pencil_field.h"

namespace pencil {

enum class MethodName { surface, line, hybrid };
enum class Initial { direct, emission, automatic };
enum class Placement { random, lds, near_surface, light_rays, camera_rays, profile };
enum class Weights { dpdf, voronoi, analytic, thesis };
enum class Iterate { sets, fixed, levels };
enum class MapKind { octahedral, pyramid, cube, paraboloid };
enum class Atlas { automatic, image, buffer };

constexpr double target_of_scene = 0;    // RenderOptions::target_error: standard_target
constexpr int pencils_of_method = 0;     // RenderOptions::pencils: standard_pencils of the method
constexpr int bounces_of_scene = -2;     // RenderOptions::bounces: the scene's max_depth
constexpr int endless_bounces = -1;      // until the tolerance
constexpr double efficacy_of_scene = 0;  // RenderOptions::lumens_per_watt: standard_efficacy

struct RenderOptions {
    MethodName method = MethodName::surface;
    int pencils = pencils_of_method;         // line: of the first set; surface: of the world set of the first pass
    double decay = 0.7;                      // line: size of the next pencil set relative to the last
    int least_pencils = pencils_of_method;   // line: sets do not shrink below this
    int bounces = bounces_of_scene;          // reflections at most, direct light included
    int map = 64;                            // line: octahedral tile size, a multiple of 8 [texels]
    int radiance_map = 0;                    // line, hybrid: the same of light, not more; 0: as map
    int density_map = 0;                     // line: the same of density weights, not more; 0: as map
    Atlas atlas = Atlas::automatic;          // line, hybrid: form of the radiance maps that are looked up
    MapKind map_kind = MapKind::octahedral;  // line, hybrid: other kinds have about as many texels
    int light_samples = 64;
    Initial initial = Initial::automatic;
    std::vector<Placement> placement{Placement::lds};  // line: a mixture, in turn
    Weights weights = Weights::dpdf;                   // line
    Iterate iterate = Iterate::sets;                   // line
    std::shared_ptr<const PencilField> field;          // line, hybrid: its light instead of the sets', which are not made; surface: its
                                                       // centres, where RenderResult::field is to tell the light, instead of an image
    std::shared_ptr<FieldSource> field_source;         // line, hybrid: with field_pencils, where their light comes from; field needs none
    int field_pencils = 0;                             // of the field that a view uses (field_subset.h); 0: all
    int field_rays = 8;                                // surface, with a field: of each texel, one a pass
    bool thin = false;                                 // line, hybrid: indirect light of some pixels, and of edges (thin_film.h)
    bool keep_field = false;                           // line, hybrid: RenderResult::field
    int rays = 64;                                     // hybrid: of each surfel of the film
    double seconds = 0;                                // surface: passes until then, 0: until target_error
    double target_error = target_of_scene;             // surface: estimated relMSE at which to stop
    double tolerance = 1e-3;                           // of the radiance a bounce adds, relative to the sum
    int width = 0, height = 0;                         // 0: the scene's film size [pixels]
    std::uint64_t seed = 0;
    int film_samples = 16;                           // visibility samples per pixel, 1 to 64
    std::vector<std::string> aovs = layer_groups();  // layers besides the beauty
    double lumens_per_watt = efficacy_of_scene;      // of photometric layers
    bool irradiance = false;                         // the film shows irradiance / pi of what it sees instead of its radiance
};

/// Whether a view shows a part of its field.
inline bool shows_part(const RenderOptions& options) { return options.field && options.field_source && options.field_pencils > 0; }

/// Paths along lobes are noisier than diffuse light.
constexpr double standard_target(bool lobes) { return lobes ? 4e-3 : 1e-3; }
/// Lumens of a watt of radiance in the scene's rgb: what its lights were divided by if they were given in photometric units, else that of white
/// light as Radiance has it.
constexpr double standard_efficacy(bool photometric) { return photometric ? 683 : 179; }
/// That, unless another was `asked` for.
constexpr double efficacy_of(double asked, bool photometric) { return asked == efficacy_of_scene ? standard_efficacy(photometric) : asked; }
/// Late bounces are smooth, but not constant; a place that no pencil shows has no light for rays.
constexpr int standard_least_pencils(MethodName method) { return method == MethodName::hybrid ? 32 : 16; }
/// As many as a first picture needs.
constexpr int standard_pencils(MethodName method) { return method == MethodName::surface ? 800 : 128; }

}  // namespace pencil
