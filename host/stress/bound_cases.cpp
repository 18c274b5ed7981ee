// No render without a bound: by the program's own options, at 64x64, every one of these scenes ends within the time that all cases have.
#include <algorithm>

#include "options/render_options.h"
#include "stress/geometry_scenes.h"
#include "stress/stress_cases.h"
#include "stress/stress_render.h"
#include "stress/stress_scenes.h"

namespace pencil {

namespace {

StressCase bound(const std::string& name, const std::string& what, const std::function<Scene()>& scene) {
    StressCase row{"bound-" + name, what + " at 64x64 by the program's own options", [scene](const StressRun& run) {
                       RenderOptions options;
                       options.aovs = {};
                       options.width = options.height = 64;
                       const RenderResult result = render(scene(), options, run);
                       const bool met = result.stats.estimated_error <= standard_target(false);
                       const std::vector<std::string>& warnings = result.stats.warnings;
                       const bool said = std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
                           return warning.find("--target-error") != std::string::npos || warning.find("no sum") != std::string::npos;
                       });
                       return std::vector<Measurement>{
                           below("values that are not finite", non_finite_of(result.layers), 0),
                           {"the target is met, or a warning says that it is not", met || said ? 1.0 : 0.0, 1, 1}};
                   }};
    row.quick = false;
    return row;
}

}  // namespace

std::vector<StressCase> bound_cases() {
    return {bound(
                "furnished-room", "furnished room", [] { return furnished_room(); }),
            bound(
                "lit-cube-0.9999", "lit cube of albedo 0.9999", [] { return lit_cube(0.9999F); }),
            bound(
                "furnace-1", "furnace of albedo 1", [] { return furnace_room(1.0F); }),
            bound(
                "dust", "furnace with 1000 triangles of 1e-7", [] { return dust_scene(1000, 1e-7); }),
            bound(
                "needles", "furnace with 500 needles", [] { return needle_scene(); }),
            bound(
                "twelve-decades", "floor of squares from 1e-6 to 1e6", [] { return decades_scene(); }),
            bound(
                "point-light-1e-4", "point light 1e-4 from a floor", [] { return near_floor_scene(1e-4); }),
            bound(
                "eye-in-a-sphere", "eye in a closed sphere", [] { return eye_in_a_sphere(); }),
            bound(
                "millimetre-in-kilometre", "closed box of 1 mm on a floor of 1 km", [] { return millimetre_box(); })};
}

}  // namespace pencil
