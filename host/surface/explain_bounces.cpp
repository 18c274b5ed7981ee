#include "surface/explain_bounces.h"

#include <fmt/format.h>

namespace pencil {

std::string explain_bounces(const BounceSolve& solve, double residual) {
    return fmt::format("reflections between pencils: {} one by one, {}; each of many leaves about {:.6f} of the light, residual {:.2g}",
                       solve.steps,
                       solve.krylov > 0 ? fmt::format("the rest by GMRES in {} applications", solve.krylov)
                                        : std::string("the rest is a geometric series"),
                       solve.spectral_radius, residual);
}

std::string unfinished_bounces(const BounceSolve& solve, double residual) {
    if (solve.has_sum)
        return fmt::format(
            "reflections are not added up to --tolerance: what is missing is estimated as {:.2g} of them, each of many leaves {:.7f} of "
            "the "
            "light; albedos a little lower or --bounces K help",
            residual, solve.spectral_radius);
    return fmt::format(
        "light has no way out and no surface keeps it (albedo 1 in a closed scene): reflections have no sum, the image shows the first {} "
        "of them; lower the albedos or say --bounces K",
        solve.steps + 2);
}

}  // namespace pencil
