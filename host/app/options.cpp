#include "app/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "options/option_values.h"
#include "options/render_option_table.h"

namespace pencil {

namespace {

using Rows = std::vector<Option>;

constexpr int most_paths = 1 << 24, most_depth = 1000, most_seeds = 1000, most_baked = 1 << 16, most_rounds = 100;
constexpr double longest_tracing = 1e6, longest_run = 86400;  // [s]

void append(Rows& rows, Rows more) { std::move(more.begin(), more.end(), std::back_inserter(rows)); }

Option path_row(const std::string& flag, const std::string& value, std::filesystem::path& path, const std::string& help) {
    return {flag, value, "", "", help, "", [&path](const std::string& text) { path = text; }, {}};
}

Option surface_row(Option row) {
    row.methods = "surface";
    return row;
}

Option lines_row(Option row) {
    row.methods = "line, hybrid";
    return row;
}

Option required(Option row) {
    row.required = true;
    return row;
}

Option switch_row(const std::string& flag, bool& value, const std::string& help) {
    return {flag, "", "", "", help, "", [&value](const std::string&) { value = true; }, {}};
}

Option define_row(std::map<std::string, std::string>& defines) {
    Option row{"-D,--define",
               "NAME=VALUE",
               "",
               "",
               "Replaces the value of a <default> of the scene; may be repeated",
               "",
               [&defines](const std::string& text) {
                   const auto [name, value] = parse_define(text);
                   defines[name] = value;
               },
               {}};
    row.repeated = true;
    return row;
}

Option allow_row(std::vector<std::filesystem::path>& allowed) {
    Option row{"--allow",
               "DIR",
               "",
               "",
               "The scene may name files in this folder, too, not only in its own; may be repeated",
               "",
               [&allowed](const std::string& text) { allowed.emplace_back(text); },
               {}};
    row.repeated = true;
    return row;
}

Rows scene_rows(std::filesystem::path& scene, LoadOptions& load) {
    return {required(path_row("SCENE", "", scene, "Scene file: Mitsuba XML, glTF (.gltf, .glb), OBJ or PLY")), define_row(load.defines),
            allow_row(load.allowed),
            switch_row("--strict", load.strict, "What the scene holds and pencil could only approximate is an error, not a warning")};
}

Option output_row(std::vector<std::filesystem::path>& outputs) {
    Option row{
        "-o,--output",
        "FILE",
        "",
        "",
        "Image to write: .exr (all layers, linear float), .png (exposure 1, sRGB), .illuminance.png or .luminance.png (false colours); may "
        "be repeated",
        "",
        [&outputs](const std::string& text) { outputs.emplace_back(text); },
        {}};
    row.repeated = true;
    return required(row);
}

Option device_row(std::string& device) {
    return {"--device",
            "D",
            "",
            "$PENCIL_DEVICE, else a GPU, else a CPU",
            "Number from `pencil devices`, part of a name, cpu or gpu",
            "",
            [&device](const std::string& text) { device = text; },
            {}};
}

Option devices_row(std::string& devices) {
    Option row = device_row(devices);
    row.value = "D[,D]";
    row.help += "; several with commas between share the work of the surface method";
    return row;
}

/// Pencils of a field that a view uses.
Option field_pencils_row(int& pencils) {
    Option row = integer_option("--field-pencils", pencils, 1, most_baked,
                                "Pencils of the field that a view uses: of those that it sees, evenly; others are not read");
    row.standard = "all";
    row.show = [&pencils] { return pencils > 0 ? OptionValue(std::int64_t{pencils}) : OptionValue(); };
    return row;
}

Option quiet_row(bool& quiet) { return switch_row("--quiet", quiet, "No progress, no summary; warnings and errors stay"); }

Option grid_row(std::vector<SensorGrid>& grids) {
    Option row{
        "--grid",
        "O;U;V;N;M",
        "",
        "",
        "Sensors in the middles of N x M cells of a parallelogram: its origin and sides, as \"0,0,0.8;4,0,0;0,3,0;8;6\"; they look along "
        "U x V; may be repeated",
        "",
        [&grids](const std::string& text) { grids.push_back(parse_grid(text)); },
        {}};
    row.repeated = true;
    return row;
}

/// Either a number of paths or a time; the other is not given.
Rows budget_rows(ReferenceOptions& o) {
    Option paths = integer_option("--spp", o.spp, 1, most_paths, "Camera paths per pixel");
    paths.show = [&o] { return o.seconds > 0 ? OptionValue() : OptionValue(std::int64_t{o.spp}); };
    Option time =
        real_option("--time", o.seconds, 0, false, longest_tracing,
                    "Trace for so many seconds instead, to within half a path per pixel and at least one; the BVH's build comes on top");
    time.value = "S";
    time.standard = "";
    time.show = [&o] { return o.seconds > 0 ? OptionValue(o.seconds) : OptionValue(); };
    return {paths, time};
}

std::vector<std::string> reference_layers() {
    std::vector<std::string> layers = layer_groups();
    layers.insert(layers.end(), photometric_layers().begin(), photometric_layers().end());
    layers.emplace_back(variance_layer);
    return layers;
}

}  // namespace

std::vector<Option> option_table(RenderCommand& command) {
    Rows rows = scene_rows(command.scene, command.load);
    rows.push_back(output_row(command.outputs));
    append(rows, render_option_table(command.options));
    append(rows,
           {devices_row(command.device),
            surface_row(path_row("--checkpoint", "FILE", command.checkpoint,
                                 "Keep FILE such that a killed render can go on from it; at most 2 % of the time")),
            surface_row(path_row("--resume", "FILE", command.resume,
                                 "Go on from a checkpoint of the same render; --time and --target-error may ask for more than it did")),
            lines_row(path_row("--field", "FILE", command.field,
                               "Light of a field that `pencil bake` has made of the scene, instead of sets of pencils")),
            lines_row(field_pencils_row(command.options.field_pencils)),
            path_row("--stats", "FILE", command.stats, "Write times, launches, residual and decisions as JSON"),
            switch_row("--explain", command.explain, "Print what was decided and what was left out, and why"), quiet_row(command.quiet)});
    return rows;
}

std::vector<Option> option_table(ReferenceCommand& command) {
    ReferenceOptions& o = command.options;
    Rows rows = scene_rows(command.scene, command.load);
    rows.push_back(output_row(command.outputs));
    append(rows, budget_rows(o));
    append(rows, {endless_option("--max-depth", o.max_depth, 1, most_depth,
                                 "Longest paths: 1 emission only, 2 with direct light; auto: no limit"),
                  resolution_option(o.width, o.height, "the scene's"),
                  list_option("--aov", command.aovs, reference_layers(), "all but illuminance, luminance, variance",
                              "Layers beside the beauty, separated by commas", photometric_layers()),
                  lumens_row(command.lumens_per_watt), seed_option(o.seed),
                  path_row("--stats", "FILE", command.stats, "Write times and counts as JSON"), quiet_row(command.quiet)});
    return rows;
}

namespace {

const std::vector<std::string> bakers{"reference", "surface", "hybrid", "line"};
constexpr int baked_pencils = 256;

Option field_rays_row(int& spp) {
    Option row = integer_option("--spp", spp, 1, most_paths, "Light paths of a texel, of the path tracer; rays of a texel, of surface");
    row.standard = fmt::format("{}; surface: {}", standard_field_paths, standard_field_rays);
    return row;
}

}  // namespace

std::string to_string(BakeFrom from) { return bakers[static_cast<std::size_t>(from)]; }

std::vector<Option> option_table(BakeCommand& command) {
    RenderOptions& o = command.options;
    o.pencils = baked_pencils;
    Rows rows = scene_rows(command.scene, command.load);
    append(rows,
           {required(path_row("-o,--output", "FILE.exr", command.output, "Field to write, for `pencil render --field`")),
            word_option("--from", command.from, bakers,
                        "What makes the light: the path tracer, pencils on surfaces, lines and rays, or lines alone"),
            integer_option("--pencils", o.pencils, 1, most_baked, "Pencils of the field"), map_option(o.map), field_rays_row(command.spp),
            integer_option("--light-samples", o.light_samples, 1, most_baked, "Point samples over all emitters, but for the path tracer"),
            seed_option(o.seed), device_row(command.device), quiet_row(command.quiet)});
    return rows;
}

namespace {

/// Of a view, which is seen for a moment.
constexpr int view_samples = 4, view_lights = 32;

}  // namespace

std::vector<Option> option_table(WalkCommand& command) {
    RenderOptions& o = command.options;
    o.weights = Weights::analytic;
    o.film_samples = view_samples;
    o.light_samples = view_lights;
    o.aovs = {};
    Rows rows = scene_rows(command.scene, command.load);
    append(rows,
           {required(path_row("--field", "FILE", command.field, "Light of the scene, by `pencil bake`")),
            required(path_row("--views", "FILE", command.views,
                              "Cameras, a line each: where it stands, where it looks, and its upward direction if that is not the scene "
                              "camera's: x,y,z,x,y,z[,x,y,z]")),
            required(path_row("-o,--output", "FILE.exr", command.output, "Images to write: FILE-0001.exr and so on")),
            field_pencils_row(o.field_pencils),
            word_option("--method", command.method, {"line", "hybrid"}, "Lines through the pencils, or lines and rays"),
            switch_row("--every-pixel", command.every_pixel,
                       "Make indirect light for all pixels, not for every third of every third row, and for edges"),
            resolution_option(o.width, o.height, "the scene's"),
            integer_option("--film-samples", o.film_samples, 1, 64, "Visibility samples of a pixel"),
            integer_option("--light-samples", o.light_samples, 1, most_baked, "Point samples over all emitters"), seed_option(o.seed),
            device_row(command.device), quiet_row(command.quiet)});
    return rows;
}

std::vector<Option> option_table(MeasureCommand& command) {
    RenderOptions& o = command.options;
    Rows rows = scene_rows(command.scene, command.load);
    Option time = real_option("--time", command.seconds, 0, false, longest_tracing, "Measures for so many seconds after loading");
    time.value = "S";
    Option target = real_option("--target-error", o.target_error, 0, false, 1,
                                "Measures until the estimated mean square of the relative errors is at most this, instead of --time");
    target.standard = "";
    target.methods = "surface";
    append(rows,
           {path_row("--points", "FILE", command.points, "Sensors, a line each: x,y,z,nx,ny,nz, or a grid of them"),
            grid_row(command.grids), path_row("-o,--output", "FILE.csv", command.output, "Table to write, instead of the standard output"),
            word_option("--method", command.method, {"surface", "reference"}, "Pencils on surfaces, or the path tracer"), time, target,
            endless_option("--bounces", o.bounces, 1, most_depth,
                           "Reflections at most, the last one that of a sensor: 1 direct light only; auto: until they add nothing"),
            lumens_row(o.lumens_per_watt), seed_option(o.seed), device_row(command.device), quiet_row(command.quiet)});
    return rows;
}

std::vector<Option> option_table(InfoCommand& command) { return scene_rows(command.scene, command.load); }

std::vector<Option> option_table(CompareCommand& command) {
    return {required(path_row("IMAGE", "", command.image, "Image to judge: OpenEXR, PNG or Radiance HDR")),
            required(path_row("REFERENCE", "", command.reference, "Image taken as the truth")),
            path_row("--diff", "FILE", command.difference, "Write where the beauty differs, in false colours, .png or .exr"),
            switch_row("--json", command.json, "Print JSON instead of a table")};
}

std::vector<Option> option_table(ConvergeCommand& command) {
    Rows rows = scene_rows(command.scene, command.load);
    rows.push_back(required(path_row("-o,--output", "DIR", command.folder, "Folder for the results, made if absent")));
    Option reference =
        path_row("--reference", "FILE", command.reference, "Image taken as the truth, for example a long run of pencil reference");
    reference.standard = "made by the path tracer";
    Option longest = real_option("--longest", command.longest, 0, false, longest_run,
                                 "Seconds: the path tracer's largest budget; the budgets of a method grow until a run takes that long");
    append(rows, {reference,
                  list_option("--methods", command.methods, method_names(), "all", "Methods beside the path tracer, separated by commas"),
                  integer_option("--seeds", command.seeds, 1, most_seeds, "Runs of each budget"), longest,
                  resolution_option(command.width, command.height, "the reference's, or the scene's shape in 256 pixels"),
                  device_row(command.device), quiet_row(command.quiet)});
    return rows;
}

std::vector<Option> option_table(StressCommand& command) {
    Option named{"--case",
                 "NAME",
                 "",
                 "the quick ones",
                 "Only this case; may be repeated",
                 "",
                 [&command](const std::string& text) { command.cases.push_back(text); },
                 {}};
    named.repeated = true;
    return {named, switch_row("--all", command.all, "Slow cases, too"), switch_row("--json", command.json, "Print JSON"),
            switch_row("--markdown", command.markdown, "Print the table of docs/stability.md"), device_row(command.device)};
}

std::vector<Option> option_table(TuneCommand& command) {
    return {device_row(command.device), integer_option("--rounds", command.rounds, 1, most_rounds, "Runs of each variant, by turns"),
            quiet_row(command.quiet)};
}

std::vector<Option> option_table(DevicesCommand& command) {
    return {switch_row("--self-test", command.self_test, "Run known answers on every device; exit status 4 if one is wrong")};
}

std::vector<Option> option_table(DocumentCommand& command) {
    const std::vector<std::string> formats{"markdown", "man", "programs"};
    return {required({"FORMAT",
                      "",
                      join(formats),
                      "",
                      "What to write to the standard output",
                      "",
                      [&command, formats](const std::string& text) { command.format = formats[parse_choice(text, formats)]; },
                      {}})};
}

std::vector<Option> option_table(BuildKernelsCommand&) { return {}; }

}  // namespace pencil
