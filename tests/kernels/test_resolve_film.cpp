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
              width, height, Buffer<float>(device(), behind, "background"), background ? 1 : 0, image)
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

}  // namespace
