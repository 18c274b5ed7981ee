// Any bytes as a lamp's photometry: an error that names the place, or angles that rise and values that a lamp can have.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/check_mesh.h"
#include "scene/read_ies.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using pencil::fuzz::require;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    pencil::fuzz::accept_scene_errors([&] {
        const pencil::PhotometricData lamp = pencil::read_ies(text, "input.ies");
        const auto& [vertical, horizontal, values] = lamp.profile;
        require(std::isfinite(lamp.candela) && lamp.candela >= 0);
        require(values.size() == vertical.size() * horizontal.size());
        for (const auto* angles : {&vertical, &horizontal}) require(std::is_sorted(angles->begin(), angles->end()));
        require(std::all_of(values.begin(), values.end(), [](auto value) { return std::isfinite(value) && value >= 0; }));
    });
    return 0;
}
