// Any bytes as the sums of a checkpoint of a film of six pixels: ArchiveError, or sums that can be used.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "film/layer_mean.h"
#include "fuzz/check_mesh.h"

namespace {

constexpr std::size_t pixels = 6;

void use(pencil::LayerMean& mean) {
    if (mean.count() == 0) return;
    mean.usual_values();
    mean.relative_mean_square_error();
    mean.mean_square_noise();
    for (const pencil::Layer& layer : mean.take())
        pencil::fuzz::require(layer.pixels.size() == pixels * static_cast<std::size_t>(layer.channels));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    pencil::Archive archive(std::vector<char>(data, data + size));
    pencil::LayerMean mean;
    try {
        mean.transfer(archive, pixels);
    } catch (const pencil::ArchiveError&) {
        return 0;
    }
    use(mean);
    return 0;
}
