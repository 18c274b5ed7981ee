// What `pencil render` was asked to do, and the reading of it from the command line.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reference/path_tracer.h"
#include "scene/scene.h"
#include "render/render.h"

namespace CLI {
class App;
}

namespace pencil {

using SceneDefines = std::map<std::string, std::string>;

struct RenderCommand {
    std::filesystem::path scene;
    SceneDefines defines;
    std::vector<std::filesystem::path> outputs;
    std::vector<std::string> aovs;
    RenderOptions options;       // all but `pencils` and `bounces`
    std::optional<int> pencils;  // absent: what suits the method
    std::optional<int> bounces;  // -1: auto; absent: what the scene says
    std::string device;
    std::filesystem::path stats;  // empty: none
    bool explain = false, quiet = false;
};

struct ReferenceCommand {
    std::filesystem::path scene;
    SceneDefines defines;
    std::vector<std::filesystem::path> outputs;
    std::vector<std::string> aovs;
    ReferenceOptions options;      // all but `max_depth` and the wanted layers
    std::optional<int> max_depth;  // -1: no limit; absent: what the scene says
    std::filesystem::path stats;   // empty: none
    bool quiet = false;
};

struct InfoCommand {
    std::filesystem::path scene;
    SceneDefines defines;
};

struct CompareCommand {
    std::filesystem::path image, reference;
    std::filesystem::path difference;  // empty: none
    bool json = false;
};

struct ConvergeCommand {
    std::filesystem::path scene;
    SceneDefines defines;
    std::filesystem::path reference;  // empty: made by the path tracer
    std::filesystem::path folder;
    std::vector<std::string> methods;
    int seeds = 3;
    double longest = 10;        // [s] where budgets stop growing
    int width = 0, height = 0;  // 0: the reference's size, or the scene's shape
    std::string device;
    bool quiet = false;
};

struct DevicesCommand {
    bool self_test = false;
};

/// Declares the options of a sub-command; parsing fills `command`, which must live as long as `app`.
void add_render_options(CLI::App& app, RenderCommand& command);
void add_reference_options(CLI::App& app, ReferenceCommand& command);
void add_info_options(CLI::App& app, InfoCommand& command);
void add_compare_options(CLI::App& app, CompareCommand& command);
void add_converge_options(CLI::App& app, ConvergeCommand& command);
void add_devices_options(CLI::App& app, DevicesCommand& command);

/// RenderOptions::bounces: --bounces if given, otherwise the scene's max_depth, which counts the emitter as the first vertex.
int reflections(const std::optional<int>& bounces, const Scene& scene);

const std::vector<std::string>& all_aovs();
const std::vector<std::string>& all_reference_aovs();
/// What `converge` can measure beside the path tracer.
const std::vector<std::string>& all_method_names();

/// As the command line spells them.
std::string to_string(Method value);
std::string to_string(Initial value);
std::string to_string(const std::vector<Placement>& mixture);
std::string to_string(Weights value);
std::string to_string(Iterate value);

}  // namespace pencil
