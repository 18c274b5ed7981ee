// How far film pencils reach beside neighbours that see an emitter.
#include "kernels/lattice_test.h"
#include "reference/tolerances.h"
#include "surface/limit_reuse.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr int reach = 2;

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
                    if (reuse.distance < ref::infinite) least = std::min(least, reuse.distance + static_cast<double>(other.emitters));
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
    for (SurfacePencil& p : pencils) p.emitters = HUGE_VALF;
    for (const SurfacePencil& p : limited(film, pencils, 2, 0)) ASSERT_EQ(p.facing.w, p.position.w);
}

}  // namespace
