// Illuminance at sensors, by the surface method or by the path tracer.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cl/device.h"
#include "measure/sensors.h"
#include "options/reference_options.h"
#include "options/render_options.h"
#include "options/render_result.h"

namespace pencil {

/// [lx]
struct Illuminance {
    double value = 0, low = 0, high = 0;  // low and high hold the true value 95 times of 100
    double direct = 0;                    // of light that comes straight from its source; the rest is indirect()
    double indirect() const { return value - direct; }
};

struct Measurements {
    std::vector<Illuminance> sensors;
    int passes = 0;            // of the surface method
    CertifiedError certified;  // of it
    std::vector<std::string> warnings;
    bool interrupted = false;  // stopped early: the values are those of what was finished; none at all if `sensors` is empty
    bool converged = true;     // false: reflections have no sum, so no value has an upper end; a warning says why
};

/// By the surface method, whatever `options` say; their film and layers have no meaning here. Pass by pass, direct light alone is measured at the
/// same places: what both share is not in their difference.
Measurements measure(const Scene& scene, const std::vector<Sensor>& sensors, const RenderOptions& options,
                     const std::shared_ptr<Device>& device, const Progress& progress = {});

/// By paths that begin at the sensors.
Measurements measure_by_paths(const Scene& scene, const std::vector<Sensor>& sensors, const ReferenceOptions& options,
                              double lumens_per_watt, const Progress& progress = {});

}  // namespace pencil
