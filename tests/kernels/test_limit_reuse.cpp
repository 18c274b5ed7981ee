// How far film pencils reach beside neighbours that see an emitter, or something much nearer.
#include "kernels/lattice_test.h"
#include "reference/tolerances.h"
#include "surface/limit_reuse.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr int reach = 2;
constexpr double times = 4;  // what other things count

std::vector<SurfacePencil> limited(const MadeFilm& film, const std::vector<SurfacePencil>& pencils, int spacing, int first_new) {
    Kernels kernels = make_kernels();
    SurfacePencils set = on_device(pencils);
    limit_reuse(kernels, set, Buffer<int>(device(), film.at, "film pencils by pixel"), spacing, first_new, film.width, film.height);
    return set.data.read(0, pencils.size());
}

TEST(LimitReuse, IsTheReferences) {
    Random random(51);
    int clamped = 0, compared = 0;
    for (const FilmCase& c : film_cases()) {
        const MadeFilm film(c.width, c.height, c.coarsest, c.finest, 52);
        if (film.pencils.empty()) continue;
        std::vector<SurfacePencil> pencils = film.pencils;
        for (SurfacePencil& p : pencils) {
            p.emitters = random.index(4) == 0 ? static_cast<float>(random.uniform(0.01, 0.3)) : HUGE_VALF;
            p.facing.w = static_cast<float>(random.uniform(0.05, 0.8));
        }
        const int first_new = static_cast<int>(pencils.size()) / 2;
        const std::vector<SurfacePencil> got = limited(film, pencils, c.finest, first_new);
        for (int pixel = 0; pixel < c.width * c.height; ++pixel) {
            const int own = film.at[static_cast<std::size_t>(pixel)];
            if (own < 0) continue;
            const SurfacePencil& p = pencils[static_cast<std::size_t>(own)];
            const double start = own < first_new ? p.facing.w : p.position.w;
            double least = start, margin = HUGE_VAL;
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx) {
                    const int x = ref::line_away(pixel % c.width, dx, c.finest, c.width);
                    const int y = ref::line_away(pixel / c.width, dy, c.finest, c.height);
                    if (x < 0 || y < 0) continue;
                    const int index = film.at[static_cast<std::size_t>(y * c.width + x)];
                    if (index < 0) continue;
                    const SurfacePencil& other = pencils[static_cast<std::size_t>(index)];
                    const ref::Reuse reuse = ref::reuse(other, xyz(p.position), xyz(p.normal));
                    margin = std::min(margin, reuse.margin);
                    const double near = std::min(static_cast<double>(other.emitters), times * static_cast<double>(other.position.w));
                    if (reuse.distance < ref::infinite) least = std::min(least, reuse.distance + near);
                }
            if (margin < tolerance::decision) continue;
            ++compared;
            clamped += least < start ? 1 : 0;
            const SurfacePencil& q = got[static_cast<std::size_t>(own)];
            ASSERT_NEAR(q.facing.w / least, 1.0, tolerance::quotient) << "pencil " << own << ", " << name(c);
            ASSERT_EQ(xyz(q.facing), xyz(p.facing));
            ASSERT_EQ(q.position, p.position);
        }
    }
    EXPECT_GT(compared, 400);
    EXPECT_GT(clamped, 100);
}

TEST(LimitReuse, WithoutEmittersItIsTheMeanDistance) {
    const MadeFilm film(37, 23, 8, 2, 53);
    std::vector<SurfacePencil> pencils = film.pencils;
    for (SurfacePencil& p : pencils) {
        p.emitters = HUGE_VALF;
        p.position.w = 0.5F;
    }
    for (const SurfacePencil& p : limited(film, pencils, 2, 0)) ASSERT_EQ(p.facing.w, p.position.w);
}

/// A top of a relief beside a pit.
TEST(LimitReuse, NeighboursInPitsClamp) {
    const MadeFilm film(37, 23, 8, 2, 54);
    std::vector<SurfacePencil> pencils = film.pencils;
    for (std::size_t i = 0; i < pencils.size(); ++i) {
        pencils[i].emitters = HUGE_VALF;
        pencils[i].position.w = i % 2 == 0 ? 10.0F : 0.01F;
    }
    int clamped = 0;
    for (const SurfacePencil& p : limited(film, pencils, 2, 0)) clamped += p.position.w > 1 && p.facing.w < 1 ? 1 : 0;
    EXPECT_GT(clamped, 20);
}

}  // namespace
