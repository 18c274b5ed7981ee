// V(x, c) of thesis eq. (5.17) as the maps decide it. Where the four texels around the direction agree the answer must be the exact one;
// at silhouettes a map of n texels may err, and the tests measure how often: leaks (seen through something) and acne (wrongly hidden).
#include "kernels/kernel_test.h"
#include "reference/visibility_ref.h"
#include "transport/test_visibility.h"

namespace {

using namespace pencil;
using namespace pencil::test;

struct Masks {
    HostSurfels surfels;
    std::vector<uint> bits;
    std::vector<Hit> hits;
    bool sees(int surfel, int pencil) const {
        const std::size_t word = static_cast<std::size_t>(pencil / 32) * surfels.capacity + static_cast<std::size_t>(surfel);
        return (bits[word] >> (pencil % 32) & 1U) != 0U;
    }
};

Masks masks(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const std::vector<float4>& centres, int n) {
    const GeometryMaps maps = rasterized(kernels, scene, centres, n);
    Buffer<uint> mask(device(), static_cast<std::size_t>(mask_words(maps.count)) * static_cast<std::size_t>(surfels.capacity), "mask");
    test_visibility(kernels, scene, surfels, maps, mask);
    return {HostSurfels(surfels), mask.read(), maps.hits.read()};
}

/// On which side of the surfel a centre lies: > 0 in front. Near 0 float arithmetic decides.
double in_front(const HostSurfels& surfels, int i, const dvec3& centre) {
    return glm::dot(surfels.face_normal(i), centre - surfels.position(i));
}
constexpr double doubtful_side = 1e-6;

TEST(TestVisibility, InABoxEverythingInFrontIsSeen) {
    Random random(61);
    const TestScene scene = box_scene(62);
    Kernels kernels = make_kernels();
    const DeviceScene on_device(device(), scene.flat);
    for (const int limit : {1, 37, 1500}) {
        for (const int pencils : {1, 31, 33, 70}) {
            const std::vector<float4> centres = random_centres(random, pencils);
            const Masks m = masks(kernels, on_device, gathered(kernels, on_device, random_centres(random, 2), 32, limit), centres, 16);
            for (int i = 0; i < m.surfels.count; ++i) {
                for (int p = 0; p < pencils; ++p) ASSERT_TRUE(m.sees(i, p)) << "surfel " << i << " pencil " << p;
            }
        }
    }
}

TEST(TestVisibility, PencilsBehindASurfelDoNotSeeIt) {
    Random random(63);
    const TestScene scene = soup_scene(64, 25);
    Kernels kernels = make_kernels();
    const DeviceScene on_device(device(), scene.flat);
    const std::vector<float4> centres = random_centres(random, 40);
    const Masks m = masks(kernels, on_device, gathered(kernels, on_device, random_centres(random, 4), 16, 1024), centres, 16);
    for (int i = 0; i < m.surfels.count; ++i) {
        for (int p = 0; p < 40; ++p) {
            const bool nothing = m.surfels.plane(i) < 0,
                       behind = in_front(m.surfels, i, xyz(centres[static_cast<std::size_t>(p)])) < -doubtful_side;
            ASSERT_FALSE(m.sees(i, p) && (nothing || behind)) << "surfel " << i << " pencil " << p;
        }
    }
}

TEST(TestVisibility, APencilSeesTheSurfelsOfItsOwnTexels) {
    Random random(65);
    for (const int n : {4, 16, 32}) {
        const TestScene scene = room_scene(66, 30);
        Kernels kernels = make_kernels();
        const DeviceScene on_device(device(), scene.flat);
        const std::vector<float4> centres = random_centres(random, 6);
        const Masks m = masks(kernels, on_device, gathered(kernels, on_device, centres, n, 6 * n * n), centres, n);
        for (int i = 0; i < m.surfels.count; ++i) {
            const int own = i / (n * n);
            if (m.surfels.plane(i) < 0 || in_front(m.surfels, i, xyz(centres[static_cast<std::size_t>(own)])) < doubtful_side) continue;
            ASSERT_TRUE(m.sees(i, own)) << "n " << n << " tile " << own << " texel " << i % n << " " << i / n % n;
        }
    }
}

struct Rates {
    int pairs = 0, leaks = 0, acne = 0, strict = 0;
};

Rates compare_with_truth(const TestScene& scene, const std::vector<float4>& centres, const Masks& m, int n) {
    Rates out;
    for (int i = 0; i < m.surfels.count; ++i) {
        if (m.surfels.plane(i) < 0) continue;
        const dvec3 x = m.surfels.position(i);
        for (int p = 0; p < static_cast<int>(centres.size()); ++p) {
            const dvec3 c = xyz(centres[static_cast<std::size_t>(p)]);
            if (in_front(m.surfels, i, c) < doubtful_side) continue;
            const ref::Visibility truth = ref::segment_visibility(scene.triangles, x, c, {m.surfels.plane(i)});
            if (truth.margin < 1e-6) continue;
            ++out.pairs;
            if (m.sees(i, p) && !truth.visible) ++out.leaks;
            if (!m.sees(i, p) && truth.visible) ++out.acne;
            const ref::Footprint f = ref::bilinear_footprint(ref::direction_to_oct(x - c), n);
            bool all_own = true, all_one = true;
            const int first = m.hits[atlas_index(p, f.x, f.y, n)].triangle;
            for (int k = 0; k < 4; ++k) {
                const int seen = m.hits[atlas_index(p, f.x + k % 2, f.y + k / 2, n)].triangle;
                all_own = all_own && seen >= 0 && scene.triangles[static_cast<std::size_t>(seen)].plane == m.surfels.plane(i);
                all_one = all_one && seen == first;
            }
            if (all_own) {
                ++out.strict;
                EXPECT_TRUE(m.sees(i, p)) << "surfel " << i << " pencil " << p << ": all four texels show its plane";
            } else if (all_one && first >= 0) {
                const bool hides = !ref::segment_visibility({scene.triangles[static_cast<std::size_t>(first)]}, x, c, {}).visible;
                out.strict += hides ? 1 : 0;
                EXPECT_FALSE(hides && m.sees(i, p))
                    << "surfel " << i << " pencil " << p << ": all four texels show triangle " << first << " in front";
            }
        }
    }
    return out;
}

TEST(TestVisibility, LeaksAndAcneShrinkWithTheMap) {
    const TestScene scene = room_scene(67, 25);
    Kernels kernels = make_kernels();
    const DeviceScene on_device(device(), scene.flat);
    Random random(68);
    const std::vector<float4> centres = random_centres(random, 24), viewers = random_centres(random, 3);
    double last = 1.0;
    for (const int n : {8, 32, 128}) {
        const Masks m = masks(kernels, on_device, gathered(kernels, on_device, viewers, 32, 3000), centres, n);
        const Rates r = compare_with_truth(scene, centres, m, n);
        const double leaks = static_cast<double>(r.leaks) / r.pairs, acne = static_cast<double>(r.acne) / r.pairs;
        std::printf("n %3d: %d pairs, decided by agreeing texels %.1f %%, leaks %.3f %%, acne %.3f %%\n", n, r.pairs,
                    100.0 * r.strict / r.pairs, 100 * leaks, 100 * acne);
        EXPECT_GT(r.pairs, 10000);
        EXPECT_LE(leaks + acne, n == 8 ? 0.10 : n == 32 ? 0.03 : 0.01) << "n " << n;
        EXPECT_LT(leaks + acne, last) << "n " << n;
        last = leaks + acne;
    }
}

}  // namespace
