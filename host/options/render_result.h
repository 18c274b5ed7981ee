// What a render gives: layers, and what it did.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "options/layer.h"
#include "options/pencil_field.h"
#include "util/launch_times.h"

namespace pencil {

struct StageTime {
    std::string name;
    double wall_seconds = 0;
    double device_seconds = 0;
    int launches = 0;
    std::map<std::string, LaunchTimes> kernels;  // the same, by launch description
};

/// What one reflection added to the image.
struct BounceReport {
    int order = 0;                  // 1: direct light
    int pencils = 0;                // size of the set that carried it, 0 if none did
    glm::dvec3 mean{0};             // over the film, of the radiance added
    double projection_seconds = 0;  // device time of the projection-scatter of that set
};

/// Standard errors on each side of an interval that holds the truth 95 times of 100.
constexpr double interval_errors = 1.96;

/// The error of an image as independent light paths see it, bias included.
struct CertifiedError {
    double relmse = 0;          // unbiased, so it may be below 0 by chance
    double standard_error = 0;  // of that
    double mean_bias = 0;       // of the image's mean, relative to it
    double mean_error = 0;      // standard error of that
    int points = 0;             // pixels looked at; 0: nothing is known
};

/// How reflections between pencils of one set were added up: one by one, and what remains by GMRES.
struct BounceSolve {
    int steps = 0;               // one by one
    int krylov = 0;              // applications of transport after them; 0: the series had ended
    double spectral_radius = 0;  // estimated: share of the light that one of many reflections leaves; 1: all of it
    bool has_sum = true;         // false: closed and without loss, as far as float tells; the image holds the first reflections alone
};

struct RenderStats {
    std::vector<StageTime> stages;  // in order of execution; kernel builds are a stage of their own
    std::vector<BounceReport> bounces;
    double residual = 0;  // estimated radiance of the bounces that were not computed, relative to the image's mean
    int passes = 0;       // images averaged, surface method
    std::uint64_t world_pencils = 0, film_pencils = 0;  // of all passes
    double estimated_error = 0;  // relMSE of the beauty, from the spread of the passes and the check; infinite if not known
    CertifiedError certified;    // the check alone
    bool tail_closed = false;    // the residual was added as a geometric tail
    bool converged = true;       // false: reflections have no sum, or were cut before they had one; a warning says why
    BounceSolve bounce_solve;    // of the last world set
    std::map<std::string, std::uint64_t> device_pencils;  // that each device gathered, where several share them
    std::uint64_t device_peak_bytes = 0;
    std::uint64_t triangles = 0, film_surfels = 0;
    std::uint64_t blind_surfels = 0;        // film surfels that no pencil of the first set sees
    int field_pencils = 0, field_read = 0;  // of a field that is shown: how many it has, and of how many the light was read
    std::vector<std::string> explain;       // decisions and what was left out, one sentence each
    std::vector<std::string> warnings;
    std::string stopped;  // why passes ended before --target-error was met; empty: they did not
};

struct RenderResult {
    int width = 0, height = 0;
    std::vector<Layer> layers;  // beauty first
    RenderStats stats;
    std::shared_ptr<PencilField> field;  // the light of all orders in the maps of one fixed set, if it was to be kept
    bool interrupted = false;            // stopped early: the layers hold what was finished
    std::string failure;                 // so they do where the device failed, as this says
};

/// Called between launches; `fraction` in [0, 1] of the whole. Return false to stop early.
using Progress = std::function<bool(const std::string& stage, double fraction)>;

}  // namespace pencil
