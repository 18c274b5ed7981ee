#include "line/field_subset.h"

#include <algorithm>
#include <cstdint>

#include "line/find_viewers.h"

namespace pencil {

namespace {

/// Surfels of the film that are asked what they see.
constexpr int most_asked = 256;

/// Some surfels of the film, spread over it.
Surfels some_of(Kernels& kernels, const Surfels& film) {
    const int count = std::min(film.count, most_asked);
    std::vector<int> list;
    list.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) list.push_back(static_cast<int>((static_cast<std::int64_t>(2 * k + 1) * film.count) / (2 * count)));
    Surfels some(kernels, count, "surfels of a view");
    if (count > 0)
        kernels.get("pick_surfels")
            .args(film.store(), film.fields, Buffer<int>(kernels.device(), list, "surfels of a view"), count, some.store())
            .run(list.size(), "surfels of a view");
    return some;
}

/// Numbers of pencils as they are wanted: those that are seen first.
std::vector<int> wanted_order(const std::vector<int>& seen) {
    std::vector<int> order;
    for (const bool of_seen : {true, false})
        for (std::size_t i = 0; i < seen.size(); ++i)
            if ((seen[i] > 0) == of_seen) order.push_back(static_cast<int>(i));
    return order;
}

}  // namespace

std::vector<int> SubsetSlots::choose(const std::vector<int>& seen) {
    std::vector<int> order = wanted_order(seen);
    order.resize(std::min(order.size(), pencil_.size()));
    std::vector<bool> missing(seen.size(), false);
    for (const int pencil : order) missing[static_cast<std::size_t>(pencil)] = true;
    std::vector<int> free_slots;
    for (std::size_t slot = 0; slot < pencil_.size(); ++slot) {
        const int pencil = pencil_[slot];
        if (pencil >= 0 && missing[static_cast<std::size_t>(pencil)])
            missing[static_cast<std::size_t>(pencil)] = false;
        else
            free_slots.push_back(static_cast<int>(slot));
    }
    std::size_t next = 0;
    for (const int pencil : order)
        if (missing[static_cast<std::size_t>(pencil)]) pencil_[static_cast<std::size_t>(free_slots[next++])] = pencil;
    return free_slots;
}

double subset_density(const std::vector<int>& seen, int slots) {
    const auto some = std::count_if(seen.begin(), seen.end(), [](int count) { return count > 0; });
    return std::min(static_cast<double>(slots) / static_cast<double>(std::max<std::ptrdiff_t>(some, 1)), 1.0);
}

FieldSubset::FieldSubset(const PencilField& field, FieldSource& source, const std::vector<float4>& centres, int slots)
    : field_(field), source_(source), all_centres_(centres), slots_(slots), light_(centres.size()) {
    chosen_.map = field.map;
    chosen_.orders = field.orders;
    chosen_.free_share = field.free_share;
    chosen_.centres.resize(static_cast<std::size_t>(slots));
    chosen_.light.resize(3 * static_cast<std::size_t>(chosen_.width()) * static_cast<std::size_t>(chosen_.height()));
}

std::vector<int> FieldSubset::choose(Kernels& kernels, const DeviceScene& scene, const Surfels& film) {
    if (!centres_on_device_.allocated()) centres_on_device_ = Buffer<float4>(kernels.device(), all_centres_, "centres of a field");
    const std::vector<int> seen = find_viewers(kernels, scene, some_of(kernels, film), centres_on_device_);
    std::vector<int> changed = slots_.choose(seen);
    for (const int slot : changed) load(slot);
    const int slots = chosen_.count();
    share_ = field_.free_share * slots / (field_.count() * subset_density(seen, slots));
    return changed;
}

/// Light of the pencil of a slot, from the source if it is new.
void FieldSubset::load(int slot) {
    const int pencil = slots_.pencils()[static_cast<std::size_t>(slot)], map = field_.map;
    std::vector<float>& light = light_[static_cast<std::size_t>(pencil)];
    if (light.empty()) {
        light = source_.light(pencil);
        ++read_;
    }
    chosen_.centres[static_cast<std::size_t>(slot)] = field_.centres[static_cast<std::size_t>(pencil)];
    const auto row = std::ptrdiff_t{3} * map;
    for (int y = 0; y < map; ++y)
        std::copy_n(light.begin() + y * row, row, chosen_.light.begin() + static_cast<std::ptrdiff_t>(chosen_.index(slot, 0, y)));
}

std::vector<float4> FieldSubset::centres(const std::vector<int>& slots) const {
    std::vector<float4> centres;
    centres.reserve(slots.size());
    for (const int slot : slots)
        centres.push_back(all_centres_[static_cast<std::size_t>(slots_.pencils()[static_cast<std::size_t>(slot)])]);
    return centres;
}

}  // namespace pencil
