// Film reconstruction against the plain sum over all samples of all pixels, for every filter.
#include <cstring>

#include "kernels/film_test.h"
#include "pencils/film_filter.h"
#include "reference/film_ref.h"
#include "shared/film.h"
#include "shared/surfel.h"

namespace {

using namespace pencil;
using namespace pencil::test;

using Filter1 = double (*)(double);
struct FilterCase {
    ReconstructionFilter::Kind kind;
    double radius;
    Filter1 value;
};
const std::vector<FilterCase> cases{
    {ReconstructionFilter::Kind::box, 0.5, [](double x) { return ref::box_filter(x); }},
    {ReconstructionFilter::Kind::tent, 1.0, [](double x) { return ref::tent_filter(x); }},
    {ReconstructionFilter::Kind::gaussian, 2.0, [](double x) { return ref::gaussian_filter(x); }},
    {ReconstructionFilter::Kind::mitchell, 2.0, [](double x) { return ref::mitchell_filter(x); }},
    {ReconstructionFilter::Kind::catmullrom, 2.0, [](double x) { return ref::catmullrom_filter(x); }},
    {ReconstructionFilter::Kind::lanczos, 3.0, [](double x) { return ref::lanczos_filter(x); }},
};

/// Pixels: the first `simple` show nothing or, the other half of those, one surfel each; the others up to four surfels, dealt out to the samples, with
/// some samples empty.
struct Pixels {
    std::vector<unsigned char> slots, counts;
    std::vector<int> first;
    int surfels = 0;
};
Pixels random_pixels(Random& random, int count, int samples, int simple = 0) {
    Pixels out;
    for (int p = 0; p < simple; ++p) {
        const bool nothing = 2 * p < simple;
        out.slots.insert(out.slots.end(), static_cast<std::size_t>(samples), static_cast<unsigned char>(nothing ? NO_SURFEL : 0));
        out.counts.push_back(static_cast<unsigned char>(nothing ? FILM_HAS_EMPTY : 1));
        out.first.push_back(out.surfels);
        out.surfels += nothing ? 0 : 1;
    }
    for (int p = simple; p < count; ++p) {
        const int kind = random.index(4), own = kind == 0 ? 1 : 1 + random.index(std::min(samples, 4));
        bool empty = false;
        for (int s = 0; s < samples; ++s) {
            const bool nothing = kind == 3 && random.uniform() < 0.3;
            empty = empty || nothing;
            out.slots.push_back(static_cast<unsigned char>(nothing ? NO_SURFEL : s % own));
        }
        out.counts.push_back(static_cast<unsigned char>(own | (empty ? FILM_HAS_EMPTY : 0)));
        out.first.push_back(out.surfels);
        out.surfels += own;
    }
    return out;
}

/// What whole_pixels makes of values from first_field on.
Buffer<float4> whole_pixels(Kernels& kernels, const Buffer<float>& values, int first_field, int capacity, const Pixels& pixels,
                            const Buffer<float>& background, bool has_background) {
    Buffer<float4> whole(device(), pixels.counts.size(), "pixels of one thing");
    kernels.get("whole_pixels")
        .args(values, first_field, capacity, Buffer<unsigned char>(device(), pixels.counts, "counts"),
              Buffer<int>(device(), pixels.first, "first"), static_cast<int>(pixels.counts.size()), background, has_background ? 1 : 0,
              whole)
        .run(pixels.counts.size(), "whole pixels");
    return whole;
}

/// `background`: samples that show nothing show something behind it.
void check(const FilterCase& c, int width, int height, int samples, bool constant, bool background = false) {
    SCOPED_TRACE("filter " + std::to_string(static_cast<int>(c.kind)) + ", " + std::to_string(width) + " x " + std::to_string(height));
    Random random(130);
    const Pixels pixels = random_pixels(random, width * height, samples, width * height * 2 / 3);
    const int capacity = surfel_capacity(pixels.surfels), first_field = 1;
    std::vector<float> values(static_cast<std::size_t>(capacity) * 4);
    for (float& value : values) value = constant ? 1.0F : static_cast<float>(random.uniform());
    std::vector<float> behind(static_cast<std::size_t>(width * height) * 3);
    for (float& value : behind) value = background ? static_cast<float>(random.uniform()) : 0.0F;
    ReconstructionFilter filter;
    filter.kind = c.kind;
    filter.radius = c.radius;
    const std::vector<glm::vec2> offsets = film_sample_offsets(samples, 7);
    const FilterTable table = tabulate_filter(filter, offsets);
    Kernels kernels = make_kernels(false, Weights::dpdf, 0, samples);
    Buffer<float> image(device(), static_cast<std::size_t>(width * height) * 3, "image");
    const Buffer<float> nothing(device(), 1, "surfels"), light(device(), values, "values"), background_of(device(), behind, "background");
    kernels.get("resolve_film")
        .args(light, first_field, capacity, whole_pixels(kernels, light, first_field, capacity, pixels, background_of, background),
              Buffer<unsigned char>(device(), pixels.slots, "slots"), Buffer<unsigned char>(device(), pixels.counts, "counts"),
              Buffer<int>(device(), pixels.first, "first"), Buffer<float>(device(), table.weights, "weights"),
              Buffer<float>(device(), table.totals, "totals"), table.reach, samples, width, height, background_of, background ? 1 : 0,
              nothing, Buffer<unsigned char>(device(), 1, "drawn"), 0, image)
        .run(static_cast<std::size_t>(width * height), "resolve film");
    const std::vector<float> got = image.read();
    for (int p = 0; p < width * height; ++p) {
        dvec3 sum(0.0);
        double total = 0.0, magnitude = 0.0;
        for (int q = 0; q < width * height; ++q) {
            for (int s = 0; s < samples; ++s) {
                const glm::vec2 o = offsets[static_cast<std::size_t>(s)];
                const double w = c.value(q % width - p % width + static_cast<double>(o.x) - 0.5) *
                                 c.value(q / width - p / width + static_cast<double>(o.y) - 0.5);
                const unsigned char slot = pixels.slots[static_cast<std::size_t>(q * samples + s)];
                total += w;
                magnitude += std::abs(w);
                const auto surfel = static_cast<std::size_t>(pixels.first[static_cast<std::size_t>(q)] + slot);
                for (int k = 0; k < 3; ++k)
                    sum[k] += w * (slot == NO_SURFEL ? behind[static_cast<std::size_t>(3 * q + k)]
                                                     : values[static_cast<std::size_t>((first_field + k) * capacity) + surfel]);
            }
        }
        for (int k = 0; k < 3; ++k) {
            // Filters with negative lobes cancel: the error goes with the sum of magnitudes.
            ASSERT_NEAR(got[static_cast<std::size_t>(3 * p + k)], sum[k] / total, 3e-6 * magnitude / std::abs(total))
                << "pixel " << p << " channel " << k;
        }
    }
}

TEST(ResolveFilm, EveryFilterAndSize) {
    for (const FilterCase& c : cases) {
        check(c, 1, 1, 4, false);
        check(c, 7, 5, 4, false);
        check(c, 19, 13, 16, false);
        check(c, 9, 9, 5, true);
        check(c, 7, 5, 4, false, true);
        check(c, 19, 13, 4, false, true);
    }
}

constexpr int drawn_width = 7, drawn_height = 5, drawn_samples = 4, drawn_capacity = 256;

/// What a sample of a pixel shows of surfel `slot`: changes within the pixel.
double value_at(int pixel, int slot, int sample, int channel) { return 1.0 + std::sin(3.0 * pixel + 5.0 * slot + 2.0 * sample + channel); }
float behind_at(int pixel, int channel) { return 0.1F * static_cast<float>(pixel % 7) + static_cast<float>(channel); }

/// Each surfel at one of its samples.
void draw(Random& random, const Pixels& pixels, std::vector<float>& values, std::vector<unsigned char>& drawn) {
    for (int p = 0; p < drawn_width * drawn_height; ++p)
        for (int slot = 0; slot < (pixels.counts[static_cast<std::size_t>(p)] & FILM_COUNT_MASK); ++slot) {
            const auto surfel = static_cast<std::size_t>(pixels.first[static_cast<std::size_t>(p)] + slot);
            std::vector<int> own;
            for (int s = 0; s < drawn_samples; ++s)
                if (pixels.slots[static_cast<std::size_t>(p * drawn_samples + s)] == slot) own.push_back(s);
            if (own.empty()) continue;
            const int s = own[static_cast<std::size_t>(random.index(static_cast<int>(own.size())))];
            drawn[surfel] = static_cast<unsigned char>(s);
            for (int c = 0; c < 3; ++c)
                values[static_cast<std::size_t>(c * drawn_capacity) + surfel] = static_cast<float>(value_at(p, slot, s, c));
        }
}

/// What the samples themselves show through the filter; and the sum of its magnitudes over its sum.
std::pair<double, double> filtered(const Pixels& pixels, const FilterTable& table, int p, int channel) {
    const int side = 2 * table.reach + 1, px = p % drawn_width, py = p / drawn_width;
    double sum = 0, norm = 0, magnitude = 0;
    for (int y = std::max(py - table.reach, 0); y <= std::min(py + table.reach, drawn_height - 1); ++y)
        for (int x = std::max(px - table.reach, 0); x <= std::min(px + table.reach, drawn_width - 1); ++x)
            for (int s = 0; s < drawn_samples; ++s) {
                const int cell = (y - py + table.reach) * side + x - px + table.reach, q = y * drawn_width + x;
                const auto w = static_cast<double>(table.weights[static_cast<std::size_t>(cell * drawn_samples + s)]);
                const unsigned char slot = pixels.slots[static_cast<std::size_t>(q * drawn_samples + s)];
                norm += w;
                magnitude += std::abs(w);
                sum += w * (slot == NO_SURFEL ? static_cast<double>(behind_at(q, channel)) : value_at(q, slot, s, channel));
            }
    return {sum / norm, magnitude / std::abs(norm)};
}

/// Surfels of some materials that lie at drawn samples: over independent draws the mean is what the samples themselves show.
TEST(ResolveFilm, DrawnSamplesAreTheFilteredImageInTheMean) {
    constexpr int images = 6000, size = drawn_width * drawn_height;
    Random random(131);
    const Pixels pixels = random_pixels(random, size, drawn_samples);
    std::vector<float> surfels(static_cast<std::size_t>(SURFEL_FIELDS * drawn_capacity)), behind;
    for (int i = 0; i < drawn_capacity; ++i) {
        const int row = i % 6;  // more than are told apart
        std::memcpy(&surfels[static_cast<std::size_t>(SURFEL_MATERIAL * drawn_capacity + i)], &row, sizeof row);
    }
    for (int i = 0; i < 3 * size; ++i) behind.push_back(behind_at(i / 3, i % 3));
    const Buffer<unsigned char> slots(device(), pixels.slots, "slots"), counts(device(), pixels.counts, "counts");
    const Buffer<int> first(device(), pixels.first, "first");
    const Buffer<float> surfels_of(device(), surfels, "surfels"), background(device(), behind, "background");
    for (const FilterCase& c : cases) {
        SCOPED_TRACE("filter " + std::to_string(static_cast<int>(c.kind)));
        ReconstructionFilter filter;
        filter.kind = c.kind;
        filter.radius = c.radius;
        const FilterTable table = tabulate_filter(filter, film_sample_offsets(drawn_samples, 7));
        Kernels kernels = make_kernels(false, Weights::dpdf, 0, drawn_samples);
        const Buffer<float> weights(device(), table.weights, "weights"), totals(device(), table.totals, "totals");
        Buffer<float> image(device(), static_cast<std::size_t>(3 * size), "image");
        std::vector<double> mean(image.size(), 0.0);
        for (int k = 0; k < images; ++k) {
            std::vector<float> values(3 * drawn_capacity, 0.0F);
            std::vector<unsigned char> drawn(drawn_capacity, 0);
            draw(random, pixels, values, drawn);
            const Buffer<float> light(device(), values, "values");
            kernels.get("resolve_film")
                .args(light, 0, drawn_capacity, whole_pixels(kernels, light, 0, drawn_capacity, pixels, background, true), slots, counts,
                      first, weights, totals, table.reach, drawn_samples, drawn_width, drawn_height, background, 1, surfels_of,
                      Buffer<unsigned char>(device(), drawn, "drawn"), 1, image)
                .run(static_cast<std::size_t>(size), "resolve film");
            const std::vector<float> got = image.read();
            for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += static_cast<double>(got[i]) / images;
        }
        for (int p = 0; p < size; ++p)
            for (int channel = 0; channel < 3; ++channel) {
                const auto [expected, magnitude] = filtered(pixels, table, p, channel);
                ASSERT_NEAR(mean[static_cast<std::size_t>(3 * p + channel)], expected, 0.04 * magnitude)
                    << "pixel " << p << " channel " << channel;
            }
    }
}

}  // namespace
