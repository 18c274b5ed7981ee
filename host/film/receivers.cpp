#include "film/receivers.h"

#include <algorithm>
#include <cstring>

#include "pencils/low_discrepancy.h"
#include "scene/sensor_places.h"

namespace pencil {

namespace {

static_assert(sizeof(int) == sizeof(float), "surfels hold integers as the bits of floats");

float bits_of(int value) {
    float bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

/// One field of all surfels.
class Rows {
public:
    explicit Rows(Surfels& surfels) : surfels_(surfels), row_(static_cast<std::size_t>(surfels.count)) {}

    template <typename Value>
    void write(int field, Value value) {
        for (std::size_t i = 0; i < row_.size(); ++i) row_[i] = value(i);
        surfels_.data.write(row_, static_cast<std::size_t>(field) * static_cast<std::size_t>(surfels_.capacity));
    }
    void write_vectors(int field, const std::vector<glm::vec3>& vectors) {
        for (int c = 0; c < 3; ++c)
            write(
                field + c, [&](std::size_t i) { return vectors[i][c]; });
    }
    void write_all(int field, float value) {
        write(
            field, [value](std::size_t) { return value; });
    }

private:
    Surfels& surfels_;
    std::vector<float> row_;
};

}  // namespace

void make_white(Surfels& surfels, const std::vector<Material>& materials) {
    const auto count = static_cast<std::size_t>(surfels.count), capacity = static_cast<std::size_t>(surfels.capacity);
    const auto has_relief = [&](float bits) {
        int row = 0;
        std::memcpy(&row, &bits, sizeof row);
        return row != PENCIL_NO_MATERIAL && materials[static_cast<std::size_t>(row < 0 ? ~row : row)].normal_texture >= 0;
    };
    const bool some = std::any_of(materials.begin(), materials.end(), [](const Material& m) { return m.normal_texture >= 0; });
    if (some) {
        const std::vector<float> rows = surfels.data.read(SURFEL_MATERIAL * capacity, count);
        for (std::size_t c = 0; c < 3; ++c) {
            std::vector<float> normal = surfels.data.read((SURFEL_NX + c) * capacity, count);
            const std::vector<float> flat = surfels.data.read((SURFEL_GX + c) * capacity, count);
            for (std::size_t i = 0; i < count; ++i)
                if (has_relief(rows[i])) normal[i] = flat[i];
            surfels.data.write(normal, (SURFEL_NX + c) * capacity);
        }
    }
    Rows rows(surfels);
    for (int c = 0; c < 3; ++c) rows.write_all(SURFEL_ALBEDO_R + c, 1.0F);
    rows.write_all(SURFEL_MATERIAL, bits_of(PENCIL_NO_MATERIAL));
}

int count_receivers(const Scene& scene) {
    int count = 0;
    for (const SensorPoint& sensor : scene.sensor_points) count += sensor.shape >= 0 ? points_of_shape : 1;
    return count;
}

Receivers sensor_receivers(const Kernels& kernels, const Scene& scene, const FlatScene& flat, const Turn& turn) {
    const SensorPlaces places(scene);
    std::vector<glm::vec3> positions, normals;
    Receivers receivers{Surfels(kernels, count_receivers(scene), "sensors"), {}, {}};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto count = static_cast<std::uint64_t>(places.is_shape(i) ? points_of_shape : 1);
        const glm::dvec2 shift(random_unit(turn.seed, 111, i), random_unit(turn.seed, 112, i));
        for (std::uint64_t k = turn.index * count; k < (turn.index + 1) * count; ++k) {
            const SensorPlace place = places.at(i, r2_sequence(k, shift));
            const glm::dvec3 position = flat.normalisation.to_scene(place.position) + before_surface * place.normal;
            positions.emplace_back(position);
            normals.emplace_back(place.normal);
            receivers.viewers.emplace_back(position + place.normal);
        }
        receivers.counts.push_back(static_cast<int>(count));
    }
    Rows rows(receivers.surfels);
    rows.write_vectors(SURFEL_X, positions);
    rows.write_vectors(SURFEL_NX, normals);
    rows.write_vectors(SURFEL_GX, normals);
    rows.write_all(SURFEL_PLANE, bits_of(static_cast<int>(flat.planes.size()) - 1));  // flatten: that of no triangle
    if (kernels.features().outgoing()) {
        rows.write_vectors(SURFEL_OX, normals);
        for (int c = 0; c < 3; ++c) rows.write_all(SURFEL_TR + c, 1.0F);
        rows.write_all(SURFEL_SHARE, -1.0F);
    }
    make_white(receivers.surfels, {});
    return receivers;
}

}  // namespace pencil
