// The sub-commands: what each was asked to do, and what does it. Each run_ throws pencil::Error for what ends it and returns the exit code
// otherwise.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "converge/methods.h"
#include "measure/sensors.h"
#include "options/layer.h"
#include "options/reference_options.h"
#include "options/render_options.h"
#include "scene/load_options.h"
#include "util/error.h"

namespace pencil {

struct RenderCommand {
    std::filesystem::path scene;
    LoadOptions load;
    std::vector<std::filesystem::path> outputs;
    RenderOptions options;
    std::string device;
    std::filesystem::path stats;               // empty: none
    std::filesystem::path checkpoint, resume;  // empty: none
    std::filesystem::path field;               // empty: none
    bool explain = false, quiet = false;
};

struct ReferenceCommand {
    std::filesystem::path scene;
    LoadOptions load;
    std::vector<std::filesystem::path> outputs;
    std::vector<std::string> aovs = layer_groups();  // not variance: samples that give it are stratified less
    ReferenceOptions options;                        // all but the wanted layers
    double lumens_per_watt = efficacy_of_scene;      // of photometric layers
    std::filesystem::path stats;                     // empty: none
    bool quiet = false;
};

enum class BakeFrom { reference, surface, hybrid, line };
std::string to_string(BakeFrom from);
/// BakeCommand::spp that is not given.
constexpr int standard_field_paths = 64, standard_field_rays = 8;

struct BakeCommand {
    std::filesystem::path scene;
    LoadOptions load;
    std::filesystem::path output;
    BakeFrom from = BakeFrom::reference;
    RenderOptions options;  // of the set of pencils
    int spp = 0;            // rays of a texel, of the path tracer and of surface; 0: as many as the method takes
    std::string device;
    bool quiet = false;
};

enum class WalkMethod { line, hybrid };

struct WalkCommand {
    std::filesystem::path scene;
    LoadOptions load;
    std::filesystem::path field, views, output;
    WalkMethod method = WalkMethod::line;
    RenderOptions options;
    std::string device;
    bool every_pixel = false, quiet = false;
};

enum class MeasureMethod { surface, reference };

struct MeasureCommand {
    std::filesystem::path scene;
    LoadOptions load{{}, {}, false, false};  // sensors are no camera
    std::filesystem::path points;            // empty: none
    std::vector<SensorGrid> grids;
    std::filesystem::path output;  // empty: the standard output
    MeasureMethod method = MeasureMethod::surface;
    RenderOptions options;
    double seconds = 10;  // if it is not for a target
    std::string device;
    bool quiet = false;
};

struct InfoCommand {
    std::filesystem::path scene;
    LoadOptions load;
};

struct CompareCommand {
    std::filesystem::path image, reference;
    std::filesystem::path difference;  // empty: none
    bool json = false;
};

struct ConvergeCommand {
    std::filesystem::path scene;
    LoadOptions load;
    std::filesystem::path reference;  // empty: made by the path tracer
    std::filesystem::path folder;
    std::vector<std::string> methods = method_names();
    int seeds = 3;
    double longest = 10;        // [s] where budgets stop growing
    int width = 0, height = 0;  // 0: the reference's size, or the scene's shape
    std::string device;
    bool quiet = false;
};

struct StressCommand {
    std::vector<std::string> cases;  // empty: the quick ones
    bool all = false, json = false, markdown = false;
    std::string device;
};

struct TuneCommand {
    std::string device;
    int rounds = 7;
    bool quiet = false;
};

struct DevicesCommand {
    bool self_test = false;
};

struct DocumentCommand {
    std::string format;  // markdown, man, programs
};

/// `pencil build-kernels`, which a render starts beside itself (cl/build_ahead.h).
struct BuildKernelsCommand {};

ExitCode run_render(const RenderCommand& command);
ExitCode run_reference(const ReferenceCommand& command);
ExitCode run_bake(const BakeCommand& command);
ExitCode run_walk(const WalkCommand& command);
ExitCode run_measure(const MeasureCommand& command);
ExitCode run_info(const InfoCommand& command);
ExitCode run_compare(const CompareCommand& command);
ExitCode run_converge(const ConvergeCommand& command);
ExitCode run_stress(const StressCommand& command);
ExitCode run_tune(const TuneCommand& command);
ExitCode run_devices(const DevicesCommand& command);
ExitCode run_document(const DocumentCommand& command);
ExitCode run_build_kernels(const BuildKernelsCommand& command);

}  // namespace pencil
