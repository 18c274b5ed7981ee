#include "options/render_option_table.h"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>
#include <variant>

#include "options/option_values.h"
#include "shared/weights.h"
#include "util/error.h"

namespace pencil {

namespace {

/// More pencils, light samples or seconds than any device or patience has.
constexpr int many = 1 << 20;
constexpr double long_time = 1e6;
constexpr int most_bounces = 1000;
/// More than cells can be told apart.
constexpr int most_rays = PENCIL_CELL_LARGEST_GRID * PENCIL_CELL_LARGEST_GRID / PENCIL_CELL_DIRECTIONS;
constexpr double most_efficacy = 1e6;  // [lm/W]
/// Octahedral maps: whole blocks of 8 x 8 texels.
constexpr int map_step = 8, largest_map = 1024;

/// In the order of the enumerations.
const std::vector<std::string> methods{"surface", "line", "hybrid"}, initials{"direct", "emission", "auto"},
    placements{"random", "lds", "near-surface", "light-rays", "camera-rays", "profile"},
    weightings{"dpdf", "voronoi", "analytic", "thesis"}, iterations{"sets", "fixed", "levels"},
    map_kinds{"octahedral", "pyramid", "cube", "paraboloid"}, atlases{"auto", "image", "buffer"};

Option only(std::initializer_list<MethodName> served, Option option) {
    for (const MethodName method : served) option.methods += (option.methods.empty() ? "" : ", ") + to_string(method);
    return option;
}

std::vector<std::string> all_layers() {
    std::vector<std::string> layers = layer_groups();
    layers.insert(layers.end(), photometric_layers().begin(), photometric_layers().end());
    return layers;
}

Option target_row(double& target) {
    Option row =
        real_option("--target-error", target, 0, false, long_time, "Passes until the estimated relMSE is at most this, at least two");
    row.standard = fmt::format("{}; with mirrors, glass or gloss {}", standard_target(false), standard_target(true));
    return row;
}

Option pencils_row(int& pencils) {
    Option row = integer_option("--pencils", pencils, 1, many, "Pencils of the first set; surface: of the world set of the first pass");
    row.standard = fmt::format("{}; line, hybrid: {}", standard_pencils(MethodName::surface), standard_pencils(MethodName::line));
    return row;
}

Option least_pencils_row(int& least) {
    Option row =
        integer_option("--least-pencils", least, 1, many, "Sets of --iterate sets do not shrink below this, unless the first has fewer");
    row.standard = fmt::format("{}; hybrid: {}", standard_least_pencils(MethodName::line), standard_least_pencils(MethodName::hybrid));
    return row;
}

}  // namespace

namespace {

Option width_row(const std::string& flag, int& map, const std::string& help) {
    Option row = integer_option(flag, map, map_step, largest_map, help);
    row.read = [&map, read = row.read](const std::string& text) {
        read(text);
        if (map % map_step != 0) throw std::invalid_argument(fmt::format("\"{}\" is not a multiple of {}", text, map_step));
    };
    return row;
}

/// Of a part of the maps, which is not given: 0.
Option own_width_row(const std::string& flag, int& map, const std::string& help) {
    Option row = width_row(flag, map, help);
    row.standard = "that of --map";
    row.show = [&map] { return map > 0 ? OptionValue(std::int64_t{map}) : OptionValue(); };
    return row;
}

}  // namespace

Option map_option(int& map) { return width_row("--map", map, "Width of a pencil's octahedral map in texels, a multiple of 8"); }

namespace {

std::string mixture_text(const std::vector<Placement>& mixture) {
    std::string text;
    for (const Placement member : mixture) text += (text.empty() ? "" : "+") + placements[static_cast<std::size_t>(member)];
    return text;
}

Option placement_row(std::vector<Placement>& mixture) {
    return {"--placement",
            "A+B",
            join(placements),
            mixture_text(mixture),
            "Where the pencils lie, or several such sets in equal parts, like lds+near-surface",
            "",
            [&mixture](const std::string& text) {
                mixture.clear();
                for (const std::size_t index : parse_mixture(text, placements)) mixture.push_back(static_cast<Placement>(index));
            },
            [&mixture] { return OptionValue(mixture_text(mixture)); }};
}

Option time_row(double& seconds) {
    Option row = real_option("--time", seconds, 0, false, long_time,
                             "Passes for so many seconds after loading, at least one, instead of --target-error");
    row.value = "S";
    row.standard = "";
    row.show = [&seconds] { return seconds > 0 ? OptionValue(seconds) : OptionValue(); };
    return row;
}

}  // namespace

Option lumens_row(double& lumens_per_watt) {
    Option row = real_option("--lumens-per-watt", lumens_per_watt, 0, false, most_efficacy,
                             "Lumens of a unit of power in the scene's lights: 1 where their numbers are photometric already");
    row.standard = fmt::format("{}, as in Radiance; with lights of glTF, or IES files without an intensity of their own, {}",
                               standard_efficacy(false), standard_efficacy(true));
    return row;
}

std::string to_string(MethodName method) { return methods[static_cast<std::size_t>(method)]; }

namespace {

/// A value as the command line would spell it.
struct Spell {
    std::string operator()(std::monostate) const { return ""; }
    std::string operator()(double value) const { return format_real(value); }
    std::string operator()(const std::string& value) const { return value; }
    std::string operator()(const std::vector<std::string>& values) const {
        return values.empty() ? "none" : fmt::format("{}", fmt::join(values, ","));
    }
    template <typename Integer>
    std::string operator()(Integer value) const {
        return std::to_string(value);
    }
};

}  // namespace

std::string spelled(const OptionValue& value) { return std::visit(Spell(), value); }

void check_options(RenderOptions options) {
    for (const Option& row : render_option_table(options)) {
        const OptionValue value = row.show();
        if (std::holds_alternative<std::monostate>(value)) continue;
        try {
            row.read(spelled(value));
        } catch (const std::invalid_argument& error) {
            throw UsageError(fmt::format("{}: {}", row.flag, error.what()));
        }
    }
}

std::vector<Option> render_option_table(RenderOptions& o) {
    constexpr MethodName line = MethodName::line, hybrid = MethodName::hybrid, surface = MethodName::surface;
    return {
        word_option("--method", o.method, methods,
                    "Pencils on surfaces; line projection, the thesis' method; or lines and rays of the surfels, balanced. An option of "
                    "one of the last two selects it"),
        only({surface}, time_row(o.seconds)),
        only({surface}, target_row(o.target_error)),
        pencils_row(o.pencils),
        only({line, hybrid},
             real_option("--decay", o.decay, 0, false, 1, "Size of each further set relative to the last, of --iterate sets")),
        only({line, hybrid}, least_pencils_row(o.least_pencils)),
        endless_option("--bounces", o.bounces, 0, most_bounces,
                       "Reflections at most: 0 emission only, 1 direct light only; auto: until --tolerance"),
        real_option("--tolerance", o.tolerance, 0, false, 1,
                    "Stop when a bounce adds less than this share; the rest is estimated and reported"),
        only({line, hybrid}, map_option(o.map)),
        only({line, hybrid}, own_width_row("--radiance-map", o.radiance_map, "Width of the maps by which light is found, at most --map")),
        only({line}, own_width_row("--density-map", o.density_map,
                                   "Width of the maps by which densities are found, for --weights that have any, at most --map")),
        only({line, hybrid},
             word_option("--map-kind", o.map_kind, map_kinds,
                         "Projection of a pencil's map; the others have about as many texels as the octahedral one: 2 squares, of the "
                         "cube 6, of width N / sqrt(2), N / sqrt(6), to the nearest multiple of 4")),
        only({line, hybrid},
             word_option("--atlas", o.atlas, atlases,
                         "Radiance maps are looked up as an image, which the device filters, or in a buffer; auto: as `pencil tune` has "
                         "measured, else in a buffer")),
        integer_option("--light-samples", o.light_samples, 1, many, "Point samples over all emitters"),
        word_option("--initial", o.initial, initials,
                    "Direct light from light samples, or from maps that carry emitted light; auto decides per emitter"),
        only({line, hybrid}, placement_row(o.placement)),
        only({line},
             word_option("--weights", o.weights, weightings,
                         "Quadrature weights of the pencils: by density of directions, by Voronoi cells, by free path; thesis is dpdf "
                         "with the printed normaliser")),
        only({line, hybrid}, word_option("--iterate", o.iterate, iterations,
                                         "A new, smaller set for each bounce; one set iterated; or levels of fewer and fewer pencils, the "
                                         "coarsest of which is iterated")),
        only({hybrid}, integer_option("--rays", o.rays, 1, most_rays,
                                      "Rays of each surfel of the film, rounded up to a square; texels of maps send a quarter as many")),
        resolution_option(o.width, o.height, "the scene's"),
        integer_option("--film-samples", o.film_samples, 1, 64, "Visibility samples of a pixel"),
        list_option("--aov", o.aovs, all_layers(), "all but illuminance, luminance", "Layers beside the beauty, separated by commas",
                    photometric_layers()),
        lumens_row(o.lumens_per_watt),
        seed_option(o.seed),
    };
}

}  // namespace pencil
