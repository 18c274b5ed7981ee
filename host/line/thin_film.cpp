#include "line/thin_film.h"

#include "shared/film.h"

namespace pencil {

namespace {

/// Arguments `counts, first_surfel, width, height`.
auto pixels(const Film& film) {
    return std::tuple<const Buffer<unsigned char>&, const Buffer<int>&, int, int>(film.counts(), film.first_surfel(), film.width(),
                                                                                  film.height());
}

std::size_t cell_count(const Film& film) {
    const auto steps = [](int pixels) { return static_cast<std::size_t>((pixels + THIN_STEP - 1) / THIN_STEP); };
    return steps(film.width()) * steps(film.height());
}

}  // namespace

ThinFilm::ThinFilm(Kernels& kernels, const Film& film) : film_(film) {
    const auto& device = kernels.device();
    const Surfels& all = film.surfels();
    const auto count = static_cast<std::size_t>(all.count);
    Buffer<unsigned char> own(device, static_cast<std::size_t>(all.capacity), "surfels with light of their own");
    kernels.get("thin_film").args(all.store(), pixels(film), own).run(cell_count(film), "thin film");
    const std::vector<unsigned char> owns = own.read(0, count);
    std::vector<int> list, place(count, -1);
    for (std::size_t i = 0; i < count; ++i) {
        if (!owns[i]) continue;
        place[i] = static_cast<int>(list.size());
        list.push_back(static_cast<int>(i));
    }
    place_ = Buffer<int>(device, place, "places of surfels");
    picked_ = Surfels(kernels, static_cast<int>(list.size()), "picked surfels");
    kernels.get("pick_surfels")
        .args(all.store(), all.fields, Buffer<int>(device, list, "picked surfels"), picked_.count, picked_.store())
        .run(list.size(), "thin film");
}

void ThinFilm::spread(Kernels& kernels, const Buffer<float>& light, Buffer<float>& outgoing) const {
    kernels.get("spread_light")
        .args(film_.surfels().store(), pixels(film_), place_, light, picked_.capacity, outgoing)
        .run(cell_count(film_), "thin film");
}

}  // namespace pencil
