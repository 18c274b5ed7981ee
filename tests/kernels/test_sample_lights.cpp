// Direct light by drawn light samples: exact where there is nothing to draw, within the step of the drawing where there are many draws, and
// light_surfels' in the mean.
#include <numeric>

#include "film/light_surfels.h"
#include "kernels/light_test.h"
#include "reference/direct_ref.h"
#include "reference/tolerances.h"
#include "reference/transport_ref.h"
#include "surface/sample_lights.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr float start = 0.5F;        // what the surfels send before
constexpr double even_share = 0.25;  // of the draws, that all samples which send anything have alike

std::vector<float> sampled(RayRoom& room, int stride, int draws, uint seed) {
    Buffer<float> outgoing(device(), std::vector<float>(static_cast<std::size_t>(room.surfels.capacity) * 3, start), "outgoing");
    sample_lights(room.kernels, room.on_device, room.surfels, room.lights, stride, draws, seed, outgoing);
    return outgoing.read();
}

TEST(SampleLights, OneSampleIsTakenWhole) {
    for (const int count : {1, 37, 700}) {
        RayRoom room(111, 30, 1, count);
        const HostSurfels host(room.surfels);
        for (const int draws : {1, 5}) {
            const std::vector<float> got = sampled(room, 1, draws, 9);
            for (int i = 0; i < host.count; ++i) {
                const ref::DirectLight e =
                    ref::direct_irradiance(room.samples, room.scene.triangles, host.position(i), host.normal(i), host.plane(i));
                if (e.margin <= 1e-5) continue;  // a ray along an edge
                expect_close(rgb_at(got, host.capacity, i), dvec3(start) + ref::scattered_radiance(host.albedo(i), e.irradiance),
                             tolerance::accumulation, "surfel " + std::to_string(i) + " of " + std::to_string(count));
            }
        }
    }
}

/// Sums over the surfels of each packet of what a sample sends to them if nothing hides it.
std::vector<double> importance(const HostSurfels& host, const LightSample& sample) {
    const int width = device()->packet_width();
    std::vector<double> sums(static_cast<std::size_t>((host.count + width - 1) / width), 0.0);
    for (int i = 0; i < static_cast<int>(sums.size()) * width; ++i) {
        const dvec3 e = ref::sample_irradiance(sample, host.position(i), host.normal(i));
        sums[static_cast<std::size_t>(i / width)] += e.x + e.y + e.z;
    }
    return sums;
}

/// Systematic resampling takes every sample within one step of its share: many draws are light_surfels' light within a known bound.
TEST(SampleLights, ManyDrawsAreWithinAStepOfEverySample) {
    constexpr int draws = 4096;
    for (const int count : {1, 37, 700}) {
        RayRoom room(113, 30, 24, count);
        const HostSurfels host(room.surfels);
        const std::vector<float> got = sampled(room, 1, draws, 4);
        std::vector<std::vector<double>> shares;
        std::vector<double> total, reaching;
        for (const LightSample& s : room.samples) {
            shares.push_back(importance(host, s));
            total.resize(shares.back().size());
            reaching.resize(total.size());
            for (std::size_t p = 0; p < total.size(); ++p) {
                total[p] += shares.back()[p];
                reaching[p] += shares.back()[p] > 0 ? 1 : 0;
            }
        }
        for (int i = 0; i < host.count; ++i) {
            const auto packet = static_cast<std::size_t>(i / device()->packet_width());
            dvec3 expected(0), bound(0);
            double margin = 1;
            for (std::size_t s = 0; s < room.samples.size(); ++s) {
                const ref::DirectLight e =
                    ref::direct_irradiance({room.samples[s]}, room.scene.triangles, host.position(i), host.normal(i), host.plane(i));
                margin = std::min(margin, e.margin);
                expected += e.irradiance;
                const double share = (1 - even_share) * shares[s][packet] + even_share * total[packet] / reaching[packet];
                if (shares[s][packet] > 0) bound += e.irradiance * (total[packet] / draws / share);
            }
            if (margin <= 1e-5) continue;  // a ray along an edge
            const dvec3 radiance = dvec3(start) + ref::scattered_radiance(host.albedo(i), expected),
                        most = ref::scattered_radiance(host.albedo(i), bound) + 10 * tolerance::accumulation * radiance,
                        value = rgb_at(got, host.capacity, i);
            for (int c = 0; c < 3; ++c)
                ASSERT_LE(std::abs(value[c] - radiance[c]), most[c])
                    << "surfel " << i << " of " << count << ", channel " << c << ": " << value[c] << " instead of " << radiance[c];
        }
    }
}

/// z-test of the light of all surfels over independent runs, at a significance of 6e-5 (4 standard errors), for strides that leave samples
/// out and for incomplete threes.
TEST(SampleLights, IsUnbiased) {
    constexpr int runs = 1000;
    for (const int count : {24, 25})
        for (const int stride : {1, 3}) {
            RayRoom room(101, 30, count, 300);
            Buffer<float> all = surfel_rgb(device(), room.surfels.capacity, "all");
            light_surfels(room.kernels, room.on_device, room.surfels, room.lights, all, "test");
            const auto sum = [&](const std::vector<float>& rgb) {
                double light = 0;
                for (int i = 0; i < room.surfels.count; ++i) {
                    const dvec3 v = rgb_at(rgb, static_cast<std::size_t>(room.surfels.capacity), i);
                    light += v.x + v.y + v.z;
                }
                return light;
            };
            const double truth = sum(all.read());
            double mean = 0, square = 0;
            for (int run = 0; run < runs; ++run) {
                const double light = sum(sampled(room, stride, 2, static_cast<uint>(run) * 7919U)) - 3.0 * start * room.surfels.count;
                mean += light / runs;
                square += light * light / runs;
            }
            const double error = std::sqrt((square - mean * mean) / runs);
            EXPECT_GT(truth, 0.0);
            EXPECT_LT(std::abs(mean - truth), 4 * error)
                << count << " samples, stride " << stride << ": " << mean << " instead of " << truth << ", standard error " << error;
            EXPECT_LT(error, 0.02 * truth) << "the test sees a bias of a few percent";
        }
}

TEST(SampleLights, IsLightSurfelsInTheMean) {
    RayRoom room(101, 30, 24);
    Buffer<float> all = surfel_rgb(device(), room.surfels.capacity, "all"),
                  sum_of_runs = surfel_rgb(device(), room.surfels.capacity, "sampled");
    light_surfels(room.kernels, room.on_device, room.surfels, room.lights, all, "test");
    constexpr int runs = 2000;
    for (int run = 0; run < runs; ++run)
        sample_lights(room.kernels, room.on_device, room.surfels, room.lights, 2, 2, static_cast<uint>(run) * 7919U, sum_of_runs);
    const std::vector<float> truth = all.read(), mean = sum_of_runs.read();
    double sum = 0, square = 0, size = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const double t = truth[i], error = static_cast<double>(mean[i]) / runs - t;
        sum += t;
        size += t * t;
        square += error * error;
    }
    EXPECT_GT(sum, 0.0);
    // Two draws have a relative standard deviation of about 2, the mean of 2000 runs one of about 0.05.
    EXPECT_LT(std::sqrt(square / size), 0.1);
    EXPECT_NEAR(std::accumulate(mean.begin(), mean.end(), 0.0) / runs / sum, 1.0, 0.01);
}

TEST(SampleLights, WithoutSamplesNothingIsAdded) {
    RayRoom room(115, 5, 0, 37);
    for (const float value : sampled(room, 1, 2, 1)) ASSERT_EQ(value, start);
}

}  // namespace
