// Film reconstruction against the plain sum over all samples of all pixels, for every filter.
#include "kernels/film_test.h"
#include "pencils/film_filter.h"
#include "reference/film_ref.h"
#include "shared/film.h"

namespace {

using namespace pencil;
using namespace pencil::test;

using Filter1 = double (*)(double);
struct Case {
    ReconstructionFilter::Kind kind;
    double radius;
    Filter1 value;
};
const std::vector<Case> cases{
    {ReconstructionFilter::Kind::box, 0.5, [](double x) { return ref::box_filter(x); }},
    {ReconstructionFilter::Kind::tent, 1.0, [](double x) { return ref::tent_filter(x); }},
    {ReconstructionFilter::Kind::gaussian, 2.0, [](double x) { return ref::gaussian_filter(x); }},
    {ReconstructionFilter::Kind::mitchell, 2.0, [](double x) { return ref::mitchell_filter(x); }},
    {ReconstructionFilter::Kind::catmullrom, 2.0, [](double x) { return ref::catmullrom_filter(x); }},
    {ReconstructionFilter::Kind::lanczos, 3.0, [](double x) { return ref::lanczos_filter(x); }},
};

/// Random pixels: up to four surfels, dealt out to the samples, some samples empty.
struct Pixels {
    std::vector<unsigned char> slots, counts;
    std::vector<int> first;
    int surfels = 0;
};
Pixels random_pixels(Random& random, int count, int samples) {
    Pixels out;
    for (int p = 0; p < count; ++p) {
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

/// `background`: samples that show nothing show something behind it.
void check(const Case& c, int width, int height, int samples, bool constant, bool background = false) {
    SCOPED_TRACE("filter " + std::to_string(static_cast<int>(c.kind)) + ", " + std::to_string(width) + " x " + std::to_string(height));
    Random random(130);
    const Pixels pixels = random_pixels(random, width * height, samples);
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
    kernels.get("resolve_film")
        .args(Buffer<float>(device(), values, "values"), first_field, capacity, Buffer<unsigned char>(device(), pixels.slots, "slots"),
              Buffer<unsigned char>(device(), pixels.counts, "counts"), Buffer<int>(device(), pixels.first, "first"),
              Buffer<float>(device(), table.weights, "weights"), Buffer<float>(device(), table.totals, "totals"), table.reach, samples,
              width, height, Buffer<float>(device(), behind, "background"), background ? 1 : 0, Buffer<unsigned char>(device(), 1, "drawn"),
              0, image)
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
    for (const Case& c : cases) {
        check(c, 1, 1, 4, false);
        check(c, 7, 5, 4, false);
        check(c, 19, 13, 16, false);
        check(c, 9, 9, 5, true);
        check(c, 7, 5, 4, false, true);
    }
}

/// The value of a sample of a pixel, of which surfel `slot` shows it: changes within the pixel.
double value_at(int pixel, int slot, int sample, int channel) { return 1.0 + std::sin(3.0 * pixel + 5.0 * slot + 2.0 * sample + channel); }

/// Surfels that lie at drawn samples: over all draws, in step in all pixels or not, the mean is what the samples themselves show.
TEST(ResolveFilm, DrawnSamplesAreTheFilteredImageInTheMean) {
    constexpr int width = 7, height = 5, samples = 4, capacity = 256, images = 6000;
    for (const Case& c : cases) {
        SCOPED_TRACE("filter " + std::to_string(static_cast<int>(c.kind)));
        Random random(131);
        const Pixels pixels = random_pixels(random, width * height, samples);
        ReconstructionFilter filter;
        filter.kind = c.kind;
        filter.radius = c.radius;
        const FilterTable table = tabulate_filter(filter, film_sample_offsets(samples, 7));
        Kernels kernels = make_kernels(false, Weights::dpdf, 0, samples);
        const Buffer<unsigned char> slots(device(), pixels.slots, "slots"), counts(device(), pixels.counts, "counts");
        const Buffer<int> first(device(), pixels.first, "first");
        const Buffer<float> weights(device(), table.weights, "weights"), totals(device(), table.totals, "totals"),
            nothing(device(), 1, "background");
        Buffer<float> image(device(), static_cast<std::size_t>(width * height) * 3, "image");
        std::vector<double> mean(image.size(), 0.0);
        for (int k = 0; k < images; ++k) {
            std::vector<float> values(3 * capacity, 0.0F);
            std::vector<unsigned char> drawn(capacity, 0);
            for (int p = 0; p < width * height; ++p)
                for (int slot = 0; slot < (pixels.counts[static_cast<std::size_t>(p)] & FILM_COUNT_MASK); ++slot) {
                    const auto surfel = static_cast<std::size_t>(pixels.first[static_cast<std::size_t>(p)] + slot);
                    std::vector<int> own;
                    for (int s = 0; s < samples; ++s)
                        if (pixels.slots[static_cast<std::size_t>(p * samples + s)] == slot) own.push_back(s);
                    if (own.empty()) continue;
                    const int s = own[static_cast<std::size_t>(random.index(static_cast<int>(own.size())))];
                    drawn[surfel] = static_cast<unsigned char>(s);
                    for (int channel = 0; channel < 3; ++channel)
                        values[static_cast<std::size_t>(channel * capacity) + surfel] = static_cast<float>(value_at(p, slot, s, channel));
                }
            kernels.get("resolve_film")
                .args(Buffer<float>(device(), values, "values"), 0, capacity, slots, counts, first, weights, totals, table.reach, samples,
                      width, height, nothing, 0, Buffer<unsigned char>(device(), drawn, "drawn"), table.reach > 0 ? 1 : 0, image)
                .run(static_cast<std::size_t>(width * height), "resolve film");
            const std::vector<float> got = image.read();
            for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += static_cast<double>(got[i]) / images;
        }
        const int side = 2 * table.reach + 1;
        for (int p = 0; p < width * height; ++p)
            for (int channel = 0; channel < 3; ++channel) {
                double sum = 0, norm = 0, magnitude = 0;
                for (int y = std::max(p / width - table.reach, 0); y <= std::min(p / width + table.reach, height - 1); ++y)
                    for (int x = std::max(p % width - table.reach, 0); x <= std::min(p % width + table.reach, width - 1); ++x)
                        for (int s = 0; s < samples; ++s) {
                            const int cell = (y - p / width + table.reach) * side + x - p % width + table.reach, q = y * width + x;
                            const auto w = static_cast<double>(table.weights[static_cast<std::size_t>(cell * samples + s)]);
                            const unsigned char slot = pixels.slots[static_cast<std::size_t>(q * samples + s)];
                            norm += w;
                            magnitude += std::abs(w);
                            if (slot != NO_SURFEL) sum += w * value_at(q, slot, s, channel);
                        }
                ASSERT_NEAR(mean[static_cast<std::size_t>(3 * p + channel)], sum / norm, 0.04 * magnitude / std::abs(norm))
                    << "pixel " << p << " channel " << channel;
            }
    }
}

}  // namespace
