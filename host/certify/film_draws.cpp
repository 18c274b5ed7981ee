#include "certify/film_draws.h"

#include <algorithm>
#include <cmath>

#include "shared/film.h"

namespace pencil {

FilmDraws::FilmDraws(const Film& film)
    : film_(film), slots_(film.slots().read()), drawn_(film.drawn()), first_surfel_(film.first_surfel().read()) {}

/// Each sample has the weight of the one that its surfel lies at, as in resolve_film in the mean, over the sum of these: even surfaces have no
/// noise of it. Where weights may cancel it has its own.
std::vector<FilmDraws::Draw> FilmDraws::draw(std::size_t pixel, int count, double u) const {
    const FilterTable& table = film_.filter_table();
    const int width = film_.width(), height = film_.height(), reach = table.reach, x = static_cast<int>(pixel) % width,
              y = static_cast<int>(pixel) / width;
    const std::size_t samples = slots_.size() / first_surfel_.size();
    const bool at_drawn = !drawn_.empty() && *std::min_element(table.weights.begin(), table.weights.end()) >= 0;
    std::vector<Draw> all;
    std::vector<double> up_to;
    double norm = 0, sum = 0;
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
            if (x + dx < 0 || x + dx >= width || y + dy < 0 || y + dy >= height) continue;
            const int row = y + dy, column = x + dx;
            const std::size_t other = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
            const int neighbour = (dy + reach) * (2 * reach + 1) + dx + reach;
            const auto cell = static_cast<std::size_t>(neighbour);
            for (std::size_t s = 0; s < samples; ++s) {
                const unsigned char slot = slots_[other * samples + s];
                const int surfel = slot == NO_SURFEL ? -1 : first_surfel_[other] + slot;
                const std::size_t at = surfel < 0 || !at_drawn ? s : drawn_[static_cast<std::size_t>(surfel)];
                const double weight = static_cast<double>(table.weights[cell * samples + at]);
                norm += weight;
                sum += std::abs(weight);
                up_to.push_back(sum);
                all.push_back({surfel, weight < 0 ? -1.0F : 1.0F});
            }
        }
    std::vector<Draw> draws;
    if (!(norm > 0)) return draws;
    std::size_t at = 0;
    for (int k = 0; k < count; ++k) {
        const double target = (k + u) / count * sum;
        while (at + 1 < up_to.size() && up_to[at] <= target) ++at;
        draws.push_back({all[at].surfel, all[at].weight * static_cast<float>(sum / norm)});
    }
    return draws;
}

}  // namespace pencil
