// The command line by CLI11. Every value is read by option_values.h, so that each message names the option and the accepted range.
#include "app/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <limits>
#include <stdexcept>

#include "app/option_values.h"
#include "converge/methods.h"

namespace pencil {
namespace {

const std::vector<std::string> methods{"line", "surface"};
/// What only line projection knows.
const std::vector<std::string> surface_options{"--time", "--target-error"};
const std::vector<std::string> line_options{"--decay", "--map", "--placement", "--weights", "--iterate"};
const std::vector<std::string> initials{"direct", "emission", "auto"};
const std::vector<std::string> placements{"random", "lds", "near-surface", "light-rays", "camera-rays", "profile"};
const std::vector<std::string> weightings{"dpdf", "voronoi", "analytic", "thesis"};
const std::vector<std::string> iterations{"sets", "fixed"};

/// An option whose text goes to `read`, which throws std::invalid_argument with what is wrong.
CLI::Option* add(CLI::App& app, const std::string& name, const std::string& help, const std::string& type, const std::string& standard,
                 const std::function<void(const std::string&)>& read) {
    const auto checked = [name, read](const std::string& text) {
        try {
            read(text);
        } catch (const std::invalid_argument& error) {
            throw CLI::ValidationError(name, error.what());
        }
    };
    return app.add_option_function<std::string>(name, checked, help)->type_name(type)->default_str(standard);
}

void add_integer(CLI::App& app, const std::string& name, int& value, int low, int high, const std::string& help) {
    const std::string range = " [" + std::to_string(low) + " to " + std::to_string(high) + "]";
    add(app, name, help + range, "N", std::to_string(value),
        [&value, low, high](const std::string& text) { value = static_cast<int>(parse_integer(text, low, high)); });
}

template <typename Enum>
void add_choice(CLI::App& app, const std::string& name, Enum& value, const std::vector<std::string>& known, const std::string& help) {
    add(app, name, help + " {" + join(known) + "}", "WORD", known[static_cast<std::size_t>(value)],
        [&value, &known](const std::string& text) { value = static_cast<Enum>(parse_choice(text, known)); });
}

void add_scene(CLI::App& app, std::filesystem::path& scene, SceneDefines& defines) {
    app.add_option("SCENE", scene, "Scene file, Mitsuba XML")->required()->type_name("");
    app.add_option_function<std::vector<std::string>>(
           "-D,--define",
           [&defines](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) {
                   try {
                       const auto [name, value] = parse_define(text);
                       defines[name] = value;
                   } catch (const std::invalid_argument& error) {
                       throw CLI::ValidationError("-D", error.what());
                   }
               }
           },
           "Replace the value of a <default> of the scene; may be repeated")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
}

void add_outputs(CLI::App& app, std::vector<std::filesystem::path>& outputs) {
    app.add_option("-o,--output", outputs, "Image to write, .exr (all layers) or .png; may be repeated")
        ->required()
        ->type_name("FILE")
        ->allow_extra_args(false);
}

void add_resolution(CLI::App& app, int& width, int& height) {
    add(app, "--resolution", "Size of the image in pixels; the scene's if absent", "WxH", "",
        [&width, &height](const std::string& text) { std::tie(width, height) = parse_resolution(text); });
}

void add_seed(CLI::App& app, std::uint64_t& seed) {
    add(app, "--seed", "Seed of the random numbers", "S", std::to_string(seed),
        [&seed](const std::string& text) { seed = parse_seed(text); });
}

/// `aovs` holds what is wanted if nothing is said, `standard` says what that is.
void add_aovs(CLI::App& app, std::vector<std::string>& aovs, const std::vector<std::string>& known, const std::string& standard) {
    add(app, "--aov", "Layers beside the beauty, separated by commas {" + join(known) + "}, or all, or none", "A,B", standard,
        [&aovs, &known](const std::string& text) { aovs = parse_list(text, known); });
}

void add_device(CLI::App& app, std::string& device) {
    app.add_option("--device", device, "Number from `pencil devices`, part of a name, cpu or gpu")
        ->type_name("D")
        ->envname("PENCIL_DEVICE");
}

void add_solver_options(CLI::App& app, RenderCommand& command) {
    RenderOptions& options = command.options;
    const int many = 1 << 20;
    options.method = Method::surface;
    add_choice(app, "--method", options.method, methods,
               "Pencils on surfaces or line projection, the thesis' method; line if an option of it is given");
    add(app, "--time", "Surface method: seconds to render for, instead of --target-error (above 0)", "S", "",
        [&options](const std::string& text) { options.seconds = parse_real(text, 0, false, 1e6); });
    add(app, "--target-error", "Surface method: stop at this estimated relMSE (above 0)", "E", format_real(options.target_error),
        [&options](const std::string& text) { options.target_error = parse_real(text, 0, false, 1e6); });
    add(app, "--pencils", "Pencils of the first set; surface method: of the world set of the first pass [1 to 1048576]", "N",
        std::to_string(default_pencils(Method::surface)) + ", line: " + std::to_string(default_pencils(Method::line)),
        [&command](const std::string& text) { command.pencils = static_cast<int>(parse_integer(text, 1, 1 << 20)); });
    add(app, "--decay", "Size of each further set relative to the last (above 0, at most 1)", "X", format_real(options.decay),
        [&options](const std::string& text) { options.decay = parse_real(text, 0, false, 1); });
    add(app, "--bounces", "Reflections at most, direct light being the first: auto or 0 to 1000; the scene's max_depth if absent", "K", "",
        [&command](const std::string& text) { command.bounces = text == "auto" ? -1 : static_cast<int>(parse_integer(text, 0, 1000)); });
    add(app, "--map", "Width of a pencil's octahedral map in texels, a multiple of 8 [8 to 1024]", "N", std::to_string(options.map),
        [&options](const std::string& text) {
            options.map = static_cast<int>(parse_integer(text, 8, 1024));
            if (options.map % 8 != 0) {
                throw std::invalid_argument("\"" + text + "\" is not a multiple of 8");
            }
        });
    add_integer(app, "--light-samples", options.light_samples, 1, many, "Point samples over all emitters");
    add_choice(app, "--initial", options.initial, initials, "How direct light enters the first set");
    add(app, "--placement", "Where the pencils lie, or a mixture like lds+near-surface {" + join(placements) + "}", "A+B",
        to_string(options.placement), [&options](const std::string& text) {
            options.placement.clear();
            for (const std::size_t index : parse_mixture(text, placements)) options.placement.push_back(static_cast<Placement>(index));
        });
    add_choice(app, "--weights", options.weights, weightings, "Quadrature weights of the pencils");
    add_choice(app, "--iterate", options.iterate, iterations, "Shrinking sets or one fixed set");
    add(app, "--tolerance", "Stop when a bounce adds less than this share (above 0, at most 1)", "X", format_real(options.tolerance),
        [&options](const std::string& text) { options.tolerance = parse_real(text, 0, false, 1); });
    add_seed(app, options.seed);
    app.parse_complete_callback([&app, &options] {
        const auto given = [&app](const std::string& name) { return app.count(name) > 0; };
        const bool line = std::any_of(line_options.begin(), line_options.end(), given);
        if (!given("--method")) options.method = line ? Method::line : Method::surface;
        for (const std::string& name : options.method == Method::line ? surface_options : line_options)
            if (given(name)) throw CLI::ValidationError(name, "is not an option of --method " + to_string(options.method));
    });
}

void add_film_options(CLI::App& app, RenderCommand& command) {
    RenderOptions& options = command.options;
    add_resolution(app, options.width, options.height);
    add_integer(app, "--film-samples", options.film_samples, 1, 64, "Visibility samples of a pixel");
    command.aovs = all_aovs();
    add_aovs(app, command.aovs, all_aovs(), "all");
}

}  // namespace

void add_render_options(CLI::App& app, RenderCommand& command) {
    add_scene(app, command.scene, command.defines);
    add_outputs(app, command.outputs);
    add_solver_options(app, command);
    add_film_options(app, command);
    add_device(app, command.device);
    app.add_option("--stats", command.stats, "Write times, counts and decisions as JSON")->type_name("FILE");
    app.add_flag("--explain", command.explain, "Print what was decided and what was left out, and why");
    app.add_flag("--quiet", command.quiet, "No progress and no summary; warnings and errors stay");
}

void add_reference_options(CLI::App& app, ReferenceCommand& command) {
    ReferenceOptions& options = command.options;
    add_scene(app, command.scene, command.defines);
    add_outputs(app, command.outputs);
    add_integer(app, "--spp", options.spp, 1, 1 << 24, "Camera paths per pixel");
    add(app, "--time", "Seconds to trace instead of a number of paths (above 0, at most 1e+06)", "S", "",
        [&options](const std::string& text) { options.seconds = parse_real(text, 0, false, 1e6); })
        ->excludes("--spp");
    add(app, "--max-depth", "Longest paths: 1 emission, 2 direct light ... 1000, or auto for no limit; the scene's if absent", "K", "",
        [&command](const std::string& text) { command.max_depth = text == "auto" ? -1 : static_cast<int>(parse_integer(text, 1, 1000)); });
    add_seed(app, options.seed);
    add_resolution(app, options.width, options.height);
    command.aovs = all_aovs();  // samples that give a variance, too, are stratified less
    add_aovs(app, command.aovs, all_reference_aovs(), "all but variance");
    app.add_option("--stats", command.stats, "Write times and counts as JSON")->type_name("FILE");
    app.add_flag("--quiet", command.quiet, "No progress and no summary; warnings and errors stay");
}

void add_info_options(CLI::App& app, InfoCommand& command) { add_scene(app, command.scene, command.defines); }

void add_compare_options(CLI::App& app, CompareCommand& command) {
    app.add_option("IMAGE", command.image, "Image to judge: OpenEXR, PNG or Radiance HDR")->required()->type_name("");
    app.add_option("REFERENCE", command.reference, "Image taken as the truth")->required()->type_name("");
    app.add_option("--diff", command.difference, "Write the difference in false colours, .png or .exr")->type_name("FILE");
    app.add_flag("--json", command.json, "Print JSON instead of a table");
}

void add_converge_options(CLI::App& app, ConvergeCommand& command) {
    add_scene(app, command.scene, command.defines);
    app.add_option("-o,--output", command.folder, "Folder for points.csv, summary.json, index.html and images; made if absent")
        ->required()
        ->type_name("DIR");
    app.add_option("--reference", command.reference, "Image taken as the truth; made by the path tracer if absent")->type_name("FILE");
    command.methods = all_method_names();
    add(app, "--methods", "Methods beside the path tracer, separated by commas {" + join(all_method_names()) + "}, or all, or none", "A,B",
        "all", [&command](const std::string& text) { command.methods = parse_list(text, all_method_names()); });
    add_integer(app, "--seeds", command.seeds, 1, 1000, "Runs of each budget");
    add(app, "--longest", "Seconds of a run from which on budgets stop growing (above 0, at most 86400)", "S", format_real(command.longest),
        [&command](const std::string& text) { command.longest = parse_real(text, 0, false, 86400); });
    add(app, "--resolution", "Size of the image in pixels; the reference's, or the scene's shape in 256 pixels, if absent", "WxH", "",
        [&command](const std::string& text) { std::tie(command.width, command.height) = parse_resolution(text); });
    add_device(app, command.device);
    app.add_flag("--quiet", command.quiet, "No progress and no summary; warnings and errors stay");
}

void add_devices_options(CLI::App& app, DevicesCommand& command) {
    app.add_flag("--self-test", command.self_test, "Run known answers on every device; exit status 4 if one is wrong");
}

int reflections(const std::optional<int>& bounces, const Scene& scene) {
    if (bounces) {
        return *bounces;
    }
    return scene.max_depth < 0 ? -1 : std::max(scene.max_depth - 1, 0);
}

const std::vector<std::string>& all_aovs() {
    static const std::vector<std::string> names{"emission", "direct", "bounces", "albedo", "normal", "depth", "position"};
    return names;
}

const std::vector<std::string>& all_reference_aovs() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all = all_aovs();
        all.emplace_back("variance");
        return all;
    }();
    return names;
}

const std::vector<std::string>& all_method_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const MeasuredMethod& method : all_methods()) {
            all.push_back(method.name);
        }
        return all;
    }();
    return names;
}

std::string to_string(Method value) { return methods[static_cast<std::size_t>(value)]; }
std::string to_string(Initial value) { return initials[static_cast<std::size_t>(value)]; }
std::string to_string(const std::vector<Placement>& mixture) {
    std::string joined;
    for (const Placement member : mixture) joined += (joined.empty() ? "" : "+") + placements[static_cast<std::size_t>(member)];
    return joined;
}
std::string to_string(Weights value) { return weightings[static_cast<std::size_t>(value)]; }
std::string to_string(Iterate value) { return iterations[static_cast<std::size_t>(value)]; }

}  // namespace pencil
