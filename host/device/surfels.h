// Surfels in device memory, structure of arrays (kernels/shared/surfel.h), and rgb values per surfel.
#pragma once

#include <algorithm>
#include <tuple>

#include "cl/buffer.h"
#include "cl/device_profile.h"
#include "device/features.h"
#include "shared/surfel.h"

namespace pencil {

/// Capacities are multiples of this, so that blocks of packets of any width may touch the tail.
constexpr int surfel_multiple = most_lanes;

inline int surfel_capacity(int count) { return (count + surfel_multiple - 1) / surfel_multiple * surfel_multiple; }

struct Surfels {
    Surfels() = default;
    /// With the fields that these kernels write.
    Surfels(const Kernels& kernels, int surfel_count, const std::string& what)
        : Surfels(kernels.device(), surfel_count, what, kernels.features().surfel_fields()) {}
    Surfels(const std::shared_ptr<Device>& device, int surfel_count, const std::string& what, int field_count = SURFEL_FIELDS)
        : capacity(surfel_capacity(surfel_count)),
          count(surfel_count),
          fields(field_count),
          data(device, static_cast<std::size_t>(capacity) * static_cast<std::size_t>(fields), what) {
        data.fill_zero();
    }

    /// Makes room for `more` surfels behind the `count` present ones.
    void reserve(const std::shared_ptr<Device>& device, int more, const std::string& what) {
        if (count + more <= capacity) return;
        Surfels larger(device, std::max(count + more, 2 * capacity), what, fields);
        for (int f = 0; f < fields && count > 0; ++f)
            larger.data.copy_from(data, static_cast<std::size_t>(f) * static_cast<std::size_t>(capacity),
                                  static_cast<std::size_t>(f) * static_cast<std::size_t>(larger.capacity), static_cast<std::size_t>(count));
        larger.count = count;
        *this = std::move(larger);
    }

    /// Arguments `surfels, capacity, surfel_count` of kernels, and without the last.
    auto list() const { return std::tie(data, capacity, count); }
    auto store() const { return std::tie(data, capacity); }

    int capacity = 0;
    int count = 0;  // used now, at most capacity
    int fields = SURFEL_FIELDS;
    Buffer<float> data;
};

/// Rgb per surfel: [3][capacity].
inline Buffer<float> surfel_rgb(const std::shared_ptr<Device>& device, int capacity, const std::string& what) {
    Buffer<float> rgb(device, static_cast<std::size_t>(capacity) * 3, what);
    rgb.fill_zero();
    return rgb;
}

}  // namespace pencil
