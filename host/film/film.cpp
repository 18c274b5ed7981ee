#include "film/film.h"

#include <algorithm>

#include "film/rasterize_film.h"
#include "film/trace_film.h"
#include "pencils/low_discrepancy.h"
#include "shared/film.h"

namespace pencil {

namespace {

/// Strips are as high as this much memory for hits allows: enough rows to keep all units busy, little beside the rest.
constexpr std::size_t strip_bytes = std::size_t{96} << 20;
/// Surfels are numbered through square blocks of pixels, so that neighbouring surfels see neighbouring things, those of a thin film too.
constexpr int numbered_block = 8 * THIN_STEP;
/// Surfels per pixel that the estimate assumes, and rgb layers held at once.
constexpr double surfels_per_pixel = 1.2;
constexpr int layers_held = 4;
/// As a fraction of 2^32.
constexpr uint golden_section = 0x9e3779b9U;

int rows_per_strip(const Camera& camera, int samples) {
    const std::size_t row = static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(samples) * sizeof(Hit);
    return static_cast<int>(std::clamp<std::size_t>(strip_bytes / row, 1, static_cast<std::size_t>(camera.height)));
}

std::vector<int> numbers_of(const std::vector<unsigned char>& marked) {
    std::vector<int> numbers;
    for (std::size_t i = 0; i < marked.size(); ++i)
        if (marked[i] != 0) numbers.push_back(static_cast<int>(i));
    return numbers;
}

std::size_t pixel_count(const Camera& camera) { return static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height); }

}  // namespace

double film_bytes(double pixels, int samples) {
    return pixels * (samples + 1 + 4 + surfels_per_pixel * 4 * (SURFEL_FIELDS + 3 * layers_held) + (3 + 4) * 4);
}

Film::Film(Kernels& kernels, const DeviceScene& scene, const FilmCamera& camera, const ReconstructionFilter& filter, const Turn& turn,
           const std::vector<unsigned char>& split)
    : camera_(camera.camera), eye_(camera.eye), samples_(kernels.features().film_samples), strip_rows_(rows_per_strip(camera_, samples_)) {
    const auto& device = kernels.device();
    std::vector<glm::vec2> offsets = film_sample_offsets(samples_, turn.seed, turn.index);
    table_ = tabulate_filter(filter, offsets);
    if (kernels.features().wide_camera) {
        const std::vector<glm::vec2> lens = lens_points(samples_, turn.seed, turn.index);
        offsets.insert(offsets.end(), lens.begin(), lens.end());
    }
    offsets_ = Buffer<glm::vec2>(device, offsets, "film sample offsets");
    weights_ = Buffer<float>(device, table_.weights, "filter weights");
    totals_ = Buffer<float>(device, table_.totals, "filter totals");
    slots_ = Buffer<unsigned char>(device, pixel_count(camera_) * static_cast<std::size_t>(samples_), "film sample slots");
    counts_ = Buffer<unsigned char>(device, pixel_count(camera_), "film surfel counts");
    split_ = Buffer<unsigned char>(device, split.empty() ? std::vector<unsigned char>(1) : split, "pixels that are split");
    hits_ = Buffer<Hit>(device, static_cast<std::size_t>(strip_rows_) * static_cast<std::size_t>(camera_.width * samples_), "film hits");
    const bool one_strip = strip_rows_ == camera_.height;
    for (int row = 0; row < camera_.height; row += strip_rows_) {
        const int rows = std::min(strip_rows_, camera_.height - row);
        see(kernels, scene, row, rows);
        classify(kernels, scene, row, rows);
    }
    surfels_ = Surfels(kernels, number_surfels(device), "film surfels");
    drawn_ = Buffer<unsigned char>(device, static_cast<std::size_t>(surfels_.capacity), "samples that surfels lie at");
    // Elsewhere light changes little within pixels, and its noise would count by uneven weights.
    const bool changes = kernels.features().lobes || kernels.features().textures;
    at_drawn_ = !turn.alone && changes && filter.kind != ReconstructionFilter::Kind::box;
    for (int row = 0; row < camera_.height; row += strip_rows_) {
        const int rows = std::min(strip_rows_, camera_.height - row);
        if (!one_strip) see(kernels, scene, row, rows);
        write_surfels(kernels, scene, row, rows, turn);
    }
    hits_ = Buffer<Hit>();
    split_ = Buffer<unsigned char>();
    // A sample that shows nothing has no surfel that could be the mean of what lies about it.
    if (!split.empty() && !has_empty_)
        close_ups_ = look_closely(kernels, scene, {camera_, offsets_, samples_}, numbers_of(split), surfels_.count, turn);
}

Film::Film(Kernels& kernels, const Camera& camera, Receivers receivers)
    : camera_(camera),
      viewers_(std::move(receivers.viewers)),
      samples_(*std::max_element(receivers.counts.begin(), receivers.counts.end())),
      surfels_(std::move(receivers.surfels)) {
    const auto& device = kernels.device();
    const auto samples = static_cast<std::size_t>(samples_);
    table_ = {0, std::vector<float>(samples, 1.0F / static_cast<float>(samples_)), {1.0F}};
    std::vector<int> first;
    std::vector<unsigned char> slots;
    int next = 0;
    for (const int count : receivers.counts) {
        first.push_back(next);
        next += count;
        for (std::size_t s = 0; s < samples; ++s) slots.push_back(static_cast<unsigned char>(s % static_cast<std::size_t>(count)));
    }
    weights_ = Buffer<float>(device, table_.weights, "filter weights");
    totals_ = Buffer<float>(device, table_.totals, "filter totals");
    slots_ = Buffer<unsigned char>(device, slots, "slots of sensors");
    counts_ =
        Buffer<unsigned char>(device, std::vector<unsigned char>(receivers.counts.begin(), receivers.counts.end()), "counts of sensors");
    first_surfel_ = Buffer<int>(device, first, "first surfels");
    drawn_ = Buffer<unsigned char>(device, 1, "samples of sensors");
}

void Film::receive(const std::vector<Material>& materials) {
    make_white(surfels_, materials);
    has_empty_ = false;
}

void Film::see(Kernels& kernels, const DeviceScene& scene, int first_row, int rows) {
    const auto look = kernels.features().wide_camera || film_is_traced(scene, camera_) ? trace_film : rasterize_film;
    look(kernels, scene, camera_, offsets_, samples_, first_row, rows, hits_, "film hits");
}

void Film::classify(Kernels& kernels, const DeviceScene& scene, int first_row, int rows) {
    kernels.get("classify_film")
        .args(strip(first_row, rows), scene.faces(), split_, split_.size() > 1 ? 1 : 0, slots_, counts_)
        .run(static_cast<std::size_t>(rows) * static_cast<std::size_t>(camera_.width), "classify film samples");
}

/// Running sum of the counts, on the host: it is one byte per pixel, and the total is needed here to allocate the surfels.
int Film::number_surfels(const std::shared_ptr<Device>& device) {
    const std::vector<unsigned char> counts = counts_.read();
    has_empty_ = std::any_of(counts.begin(), counts.end(), [](unsigned char count) { return (count & FILM_HAS_EMPTY) != 0; });
    std::vector<int> first(counts.size());
    int next = 0;
    const int width = camera_.width, height = camera_.height;
    for (int top = 0; top < height; top += numbered_block)
        for (int left = 0; left < width; left += numbered_block)
            for (int y = top; y < std::min(top + numbered_block, height); ++y)
                for (int x = left; x < std::min(left + numbered_block, width); ++x) {
                    const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
                    first[pixel] = next;
                    next += counts[pixel] & FILM_COUNT_MASK;
                }
    first_surfel_ = Buffer<int>(device, first, "first surfels");
    return next;
}

/// Shares of samples from turn to turn are those of the golden section.
void Film::write_surfels(Kernels& kernels, const DeviceScene& scene, int first_row, int rows, const Turn& turn) {
    const uint seed = turn.alone ? 0 : static_cast<uint>(hash64(turn.seed) >> 32) | 1U,
               shift = static_cast<uint>(turn.index) * golden_section;
    kernels.get("film_surfels")
        .args(strip(first_row, rows), seed, shift, pixels(), scene.surfaces(), surfels_.store(), drawn_)
        .run(static_cast<std::size_t>(rows) * static_cast<std::size_t>(camera_.width), "film surfels");
}

std::vector<float> Film::resolve(Kernels& kernels, const Buffer<float>& values, int first_field, const Buffer<float>* background,
                                 bool at_drawn) const {
    const auto& device = kernels.device();
    Buffer<float> image(device, pixel_count(camera_) * 3, "resolved layer");
    Buffer<float4> whole(device, pixel_count(camera_), "pixels of one thing");
    const Buffer<float> nothing(device, 1, "no background");
    const auto behind = std::tuple<const Buffer<float>&, int>(background ? *background : nothing, background ? 1 : 0);
    kernels.get("whole_pixels")
        .args(values, first_field, surfels_.capacity, counts_, first_surfel_, static_cast<int>(pixel_count(camera_)), behind, whole)
        .run(pixel_count(camera_), "resolve film");
    kernels.get("resolve_film")
        .args(values, first_field, surfels_.capacity, whole, pixels(), filter(), camera_.width, camera_.height, behind, surfels_.data,
              drawn_, at_drawn ? 1 : 0, image)
        .run(pixel_count(camera_), "resolve film");
    return image.read();
}

std::vector<float> Film::resolve(Kernels& kernels, const Buffer<float>& values, const Buffer<float>* background) const {
    return resolve(kernels, values, 0, background, at_drawn_);
}

std::vector<float> Film::resolve_fields(Kernels& kernels, int first_field) const {
    return resolve(kernels, surfels_.data, first_field, nullptr, false);
}

Buffer<float> Film::sky(Kernels& kernels, const DeviceScene& scene) const {
    Buffer<float> image(kernels.device(), pixel_count(camera_) * 3, "environment behind the film");
    kernels.get("show_sky").args(camera_, offsets_, samples_, slots_, scene.environment(), image).run(pixel_count(camera_), "environment");
    return image;
}

std::vector<float> Film::cover(Kernels& kernels) const {
    const std::vector<float> ones(static_cast<std::size_t>(surfels_.capacity) * 3, 1.0F);
    return resolve(kernels, Buffer<float>(kernels.device(), ones, "ones for the covered share"), 0, nullptr, false);
}

}  // namespace pencil
