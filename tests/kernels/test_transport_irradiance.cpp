// One bounce between surface pencils: E' = 1 / n^2 sum albedo sum_j w_j E_j.
#include "kernels/surface_test.h"
#include "reference/surface_transport_ref.h"
#include "reference/tolerances.h"
#include "surface/transport_irradiance.h"

namespace {

using namespace pencil;
using namespace pencil::test;

struct World {
    int pencils, n;
    MadeSurfels surfels;
    std::vector<ref::Links> links;
};

/// Texels that see something or not, linked to 0 to 4 pencils with weights of sum 1, some of them as the last resort.
World random_world(int pencils, int n, std::uint32_t seed) {
    Random random(seed);
    World w{pencils, n, MadeSurfels(pencils * n * n), {}};
    for (int i = 0; i < w.surfels.count; ++i) {
        ref::Links links;
        const int count = random.index(5);
        double sum = 0;
        for (int k = 0; k < count; ++k) {
            links.push_back({random.index(pencils), random.uniform(0.1, 1)});
            sum += links.back().weight;
        }
        for (ref::Link& link : links) link.weight /= sum;
        w.links.push_back(links);
        w.surfels.place(i, dvec3(0), dvec3(0, 1, 0), 0, random.in_box(0, 1));
    }
    return w;
}

SurfaceLinks on_device(const std::vector<ref::Links>& links) {
    std::vector<glm::ivec4> pencils;
    std::vector<float4> weights;
    for (const ref::Links& link : links) {
        pencils.emplace_back(-1);
        weights.emplace_back(0.0F);
        for (std::size_t k = 0; k < link.size(); ++k) {
            pencils.back()[static_cast<int>(k)] = link[k].pencil;
            weights.back()[static_cast<int>(k)] = static_cast<float>(link[k].weight);
        }
        if (link.size() == 1) pencils.back().y = LINK_STANDS_IN;
    }
    return {Buffer<glm::ivec4>(device(), pencils, "links"), Buffer<float4>(device(), weights, "weights")};
}

struct Bounce {
    std::vector<float4> target, total;
};

Bounce bounce(const World& w, const std::vector<float4>& source, const std::vector<float4>& joins, const std::vector<float4>& sum) {
    Kernels kernels = make_kernels();
    Buffer<float4> target(device(), joins, "target"), total(device(), sum, "total");
    transport_irradiance(kernels, w.surfels.on_device(), on_device(w.links), w.pencils, w.n, Buffer<float4>(device(), source, "source"),
                         target, total);
    return {target.read(), total.read()};
}

TEST(TransportIrradiance, IsTheSumOverTexelsAndLinks) {
    for (const int n : {4, 8})
        for (const int pencils : {1, 37, 150}) {
            Random random(static_cast<std::uint32_t>(pencils + n));
            const World w = random_world(pencils, n, 3);
            const auto count = static_cast<std::size_t>(pencils);
            const std::vector<float4> source = random_irradiance(random, count), joins = random_irradiance(random, count),
                                      sum = random_irradiance(random, count);
            const Bounce got = bounce(w, source, joins, sum);
            for (int p = 0; p < pencils; ++p) {
                const auto at = static_cast<std::size_t>(p);
                dvec3 expected(0);
                for (int i = p * n * n; i < (p + 1) * n * n; ++i)
                    expected += w.surfels.albedo(i) * ref::linked_irradiance(w.links[static_cast<std::size_t>(i)], source);
                expected = expected / static_cast<double>(n * n) + xyz(joins[at]);
                const std::string what = "pencil " + std::to_string(p) + " of " + std::to_string(pencils);
                expect_close(xyz(got.target[at]), expected, tolerance::accumulation, what + ", target");
                expect_close(xyz(got.total[at]), expected + xyz(sum[at]), tolerance::accumulation, what + ", total");
            }
        }
}

/// A closed room of one albedo: every bounce is the albedo times the last.
TEST(TransportIrradiance, ConstantLightTimesAlbedoIsExact) {
    World w = random_world(37, 4, 5);
    const dvec3 albedo(0.5, 0.25, 0.75);
    for (int i = 0; i < w.surfels.count; ++i) {
        auto& links = w.links[static_cast<std::size_t>(i)];
        if (links.empty()) links.push_back({i % 37, 1.0});
        w.surfels.set_vector(SURFEL_ALBEDO_R, i, albedo);
    }
    const std::vector<float4> source(37, float4(2, 3, 4, 0)), dark(37, float4(0));
    for (const float4& e : bounce(w, source, dark, dark).target)
        expect_close(xyz(e), albedo * dvec3(2, 3, 4), tolerance::accumulation, "constant light");
}

TEST(TransportIrradiance, PermutingPencilsChangesNothing) {
    const World w = random_world(37, 4, 7);
    Random random(8);
    const std::vector<int> order = shuffled(random, 37);
    World turned{37, 4, MadeSurfels(w.surfels.count), {}};
    std::vector<float4> source = random_irradiance(random, 37), turned_source(37), dark(37, float4(0));
    std::vector<int> place(37);
    for (std::size_t p = 0; p < 37; ++p) place[static_cast<std::size_t>(order[p])] = static_cast<int>(p);
    for (std::size_t p = 0; p < 37; ++p) {
        turned_source[p] = source[static_cast<std::size_t>(order[p])];
        for (int i = 0; i < 16; ++i) {
            const int from = order[p] * 16 + i, to = static_cast<int>(p) * 16 + i;
            turned.surfels.place(to, dvec3(0), dvec3(0, 1, 0), 0, w.surfels.albedo(from));
            ref::Links links = w.links[static_cast<std::size_t>(from)];
            for (ref::Link& link : links) link.pencil = place[static_cast<std::size_t>(link.pencil)];
            turned.links.push_back(links);
        }
    }
    const Bounce straight = bounce(w, source, dark, dark), permuted = bounce(turned, turned_source, dark, dark);
    for (std::size_t p = 0; p < 37; ++p)
        EXPECT_EQ(permuted.target[p], straight.target[static_cast<std::size_t>(order[p])]) << "pencil " << order[p];
}

}  // namespace
