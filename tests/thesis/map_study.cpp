// Numbers for docs/thesis-results.md that no render gives: sampling rates of the map parameterisations (thesis table 6.6, figure 6.9) and
// the time of their look-ups (6.3.1). Written as JSON; scripts/thesis_results.sh makes tables and plots of it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "thesis/look_ups.h"
#include "thesis/sampling_rates.h"
#include "util/error.h"
#include "util/output_file.h"

namespace {

using namespace pencil;
using Json = nlohmann::ordered_json;

constexpr int sampling_texels = 128;  // along a side of a tile: variations to two digits
/// Sums of one map in float and in double precision differ by rounding; sums of two maps by their resolution.
constexpr double largest_rounding = 1e-3, largest_difference = 0.2;

/// p = 1.5 is for the tests of the family; of p = 4 one base shows what the general norm costs.
std::vector<ref::NamedMap> studied_maps() {
    std::vector<ref::NamedMap> maps = {{ref::octahedral_map(), "octahedral", ""}};
    for (ref::NamedMap& named : ref::comparison_maps())
        if (named.exponent != "1.5f" && !(named.exponent == "4.0f" && named.cone)) maps.push_back(std::move(named));
    return maps;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

void demand_right_sums(const std::string& map, const thesis::LookUpTimes& times) {
    if (times.reference_difference > largest_rounding || times.difference > largest_difference)
        throw DeviceError("the " + map + " look-ups are wrong: " + std::to_string(times.reference_difference) +
                          " from the double precision sums, " + std::to_string(times.difference) + " from the octahedral map's");
}

Json map_json(const ref::Map& map, const thesis::LookUpTimes& times) {
    const thesis::SamplingRates rates = thesis::sampling_rates(map, sampling_texels);
    return {{"map", map.name},
            {"tiles", map.tiles},
            {"used", rates.used},
            {"ratio", rates.ratio},
            {"variation_sphere", rates.variation_sphere},
            {"variation_texels", rates.variation_texels},
            {"deviation", rates.deviation},
            {"bin_width", thesis::SamplingRates::bin_width},
            {"histogram", rates.histogram},
            {"tile_size", times.n},
            {"launches", times.seconds.size()},
            {"look_up_seconds", median(times.seconds)},
            {"least_look_up_seconds", *std::min_element(times.seconds.begin(), times.seconds.end())},
            {"footprint_seconds", median(times.footprint_seconds)},
            {"least_footprint_seconds", *std::min_element(times.footprint_seconds.begin(), times.footprint_seconds.end())},
            {"difference_from_octahedral", times.difference}};
}

Json run(const thesis::LookUpOptions& options, const std::string& device_name) {
    const std::shared_ptr<Device> device = Device::open(device_name);
    thesis::LitPencils pencils(device, options);
    const std::vector<ref::NamedMap> maps = studied_maps();
    const std::vector<thesis::LookUpTimes> times = thesis::time_look_ups(pencils, maps, options.texels, options.repeats);
    Json json{{"device", device->info().name},
              {"platform", device->info().platform},
              {"compute_units", device->info().compute_units},
              {"packet_width", device->packet_width()},
              {"surfels", pencils.surfels().count},
              {"pencils", options.pencils},
              {"repeats", options.repeats},
              {"maps", Json::array()}};
    for (std::size_t m = 0; m < maps.size(); ++m) {
        demand_right_sums(maps[m].map.name, times[m]);
        json["maps"].push_back(map_json(maps[m].map, times[m]));
        std::cout << maps[m].map.name << ": " << 1e3 * median(times[m].seconds) << " ms\n";
    }
    return json;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Sampling rates and look-up times of map parameterisations");
    thesis::LookUpOptions options;
    options.scene = PENCIL_SOURCE_DIR "/scenes/cornell-box.xml";
    std::string output, device;
    app.add_option("-o", output, "JSON file to write")->required();
    app.add_option("--device", device, "as in `pencil render`");
    app.add_option("--resolution", options.resolution, "pixels along a side of the film")->check(CLI::Range(8, 4096));
    app.add_option("--repeats", options.repeats, "launches per median")->check(CLI::Range(1, 1000));
    CLI11_PARSE(app, argc, argv);
    try {
        const std::string text = run(options, device).dump(2) + "\n";
        write_file(output, text.data(), text.size());
    } catch (const std::exception& error) {
        std::cerr << "map_study: " << error.what() << "\n";
        return 1;
    }
    return 0;
}
