// The film: visibility samples, the surfels they show, and the way back from surfel values to pixels.
#pragma once

#include <tuple>
#include <vector>

#include "device/device_scene.h"
#include "device/features.h"
#include "device/surfels.h"
#include "device/turn.h"
#include "film/close_ups.h"
#include "film/receivers.h"
#include "pencils/film_filter.h"

namespace pencil {

/// A camera, and about where its rays come from [scene units].
struct FilmCamera {
    const Camera& camera;
    glm::vec3 eye;
};

class Film {
public:
    /// Rasterises the scene for the camera and makes the surfels (launchers of classify_film, film_surfels). `split`: not 0 for pixels whose
    /// visibility samples have a surfel each and, where the whole film shows something, close-ups; empty: none.
    Film(Kernels& kernels, const DeviceScene& scene, const FilmCamera& camera, const ReconstructionFilter& filter, const Turn& turn,
         const std::vector<unsigned char>& split = {});

    /// A row of pixels that show the receivers of a sensor each; `camera` has as many columns.
    Film(Kernels& kernels, const Camera& camera, Receivers receivers);

    /// All surfels become white receivers (make_white), before which nothing is seen.
    void receive(const std::vector<Material>& materials);

    const Surfels& surfels() const { return surfels_; }
    const Buffer<unsigned char>& counts() const { return counts_; }    // per pixel: surfels and FILM_HAS_EMPTY
    const Buffer<int>& first_surfel() const { return first_surfel_; }  // per pixel
    const Buffer<unsigned char>& slots() const { return slots_; }      // per visibility sample: its surfel's number in the pixel
    const CloseUps& close_ups() const { return close_ups_; }
    void release_close_ups() { close_ups_ = CloseUps(); }
    const FilterTable& filter_table() const { return table_; }
    int width() const { return camera_.width; }
    int height() const { return camera_.height; }
    /// A point that the surfel is seen from, about [scene units].
    glm::vec3 viewer(int surfel) const { return viewers_.empty() ? eye_ : viewers_[static_cast<std::size_t>(surfel)]; }
    /// Visibility samples of each pixel.
    int samples() const { return samples_; }
    bool is_row_of_sensors() const { return !viewers_.empty(); }

    /// Pixels (rgb, rows from the top) of light, values[3][surfels().capacity], and of `background` where samples show nothing; launcher of
    /// resolve_film. Of films that are one of many the mean of these is the filtered image, but for the
    /// background, which is a mean within pixels.
    std::vector<float> resolve(Kernels& kernels, const Buffer<float>& values, const Buffer<float>* background = nullptr) const;
    /// The same of three consecutive fields of surfels, each of which stands for its part of its pixel: no noise, but blurred within pixels.
    std::vector<float> resolve_fields(Kernels& kernels, int first_field) const;
    /// Per pixel, rgb: mean radiance of the environment over its samples that show nothing; launcher of show_sky.
    Buffer<float> sky(Kernels& kernels, const DeviceScene& scene) const;
    /// The filter's share of each pixel that shows a surface, three times over.
    std::vector<float> cover(Kernels& kernels) const;
    /// For each surfel the visibility sample of its pixel that it lies at; empty if it stands for all of its samples alike: the film is the only
    /// one, its filter is a box, or nothing changes light within pixels but shadows.
    std::vector<unsigned char> drawn() const { return at_drawn_ ? drawn_.read() : std::vector<unsigned char>(); }
    /// True if a visibility sample shows nothing.
    bool has_empty() const { return has_empty_; }

private:
    /// Arguments of kernels: `hits, camera, offsets, sample_count, first_row, row_count`; `slots, counts, first_surfel`; `weights, totals, reach,
    /// sample_count`.
    auto strip(int first_row, int rows) const {
        return std::tuple<const Buffer<Hit>&, const Camera&, const Buffer<glm::vec2>&, int, int, int>(hits_, camera_, offsets_, samples_,
                                                                                                      first_row, rows);
    }
    auto pixels() const { return std::tie(slots_, counts_, first_surfel_); }
    auto filter() const { return std::tie(weights_, totals_, table_.reach, samples_); }

    void see(Kernels& kernels, const DeviceScene& scene, int first_row, int rows);
    void classify(Kernels& kernels, const DeviceScene& scene, int first_row, int rows);
    void write_surfels(Kernels& kernels, const DeviceScene& scene, int first_row, int rows, const Turn& turn);
    int number_surfels(const std::shared_ptr<Device>& device);
    std::vector<float> resolve(Kernels& kernels, const Buffer<float>& values, int first_field, const Buffer<float>* background,
                               bool at_drawn) const;

    Camera camera_;
    glm::vec3 eye_{0.0F};
    std::vector<glm::vec3> viewers_;  // of sensors
    int samples_ = 1;
    int strip_rows_ = 1;
    bool has_empty_ = false, at_drawn_ = false;
    Buffer<glm::vec2> offsets_;
    Buffer<Hit> hits_;  // of one strip, released after construction
    Buffer<unsigned char> slots_, counts_, drawn_;
    Buffer<unsigned char> split_;  // one value, if no pixel is split
    Buffer<int> first_surfel_;
    FilterTable table_;
    Buffer<float> weights_, totals_;  // of it
    Surfels surfels_;
    CloseUps close_ups_;
};

/// Rough bytes of device memory that a film of this size takes, for the check before anything is allocated.
double film_bytes(double pixels, int samples);

}  // namespace pencil
