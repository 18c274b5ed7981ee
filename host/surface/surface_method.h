// Indirect light by pencils on surfaces: a world set for all bounces, film pencils that gather from it, and the film lit by them. An image
// is the mean of passes, which grow finer: noise and interpolation error both fall with time.
#pragma once

#include <memory>

#include "film/frame.h"
#include "film/method.h"
#include "surface/film_pencils.h"
#include "surface/pass_course.h"
#include "surface/pass_mean.h"
#include "surface/patience.h"
#include "surface/surface_pass.h"
#include "surface/surface_solver.h"
#include "util/error.h"

namespace pencil {

/// Steps: one pass each, until time or the estimated error tell to stop. The image is the mean of the passes.
class SurfaceMethod : public Method {
public:
    explicit SurfaceMethod(RenderContext& context);

    bool advance() override;
    std::vector<Layer> snapshot() const override;
    std::vector<Layer> take() override;
    void let_go() override;
    double estimated_error() const override;
    CertifiedError certified_error() const override;
    std::vector<std::string> explain() const override;
    bool resumable() const override { return true; }
    void transfer(Archive& archive) override;

private:
    bool add_pass();
    bool add_pass(const SurfacePass& pass);
    bool be_thrifty(const MemoryError& error);
    void begin_frame(int index, const SurfacePass& pass, const std::vector<std::string>& aovs, const std::vector<unsigned char>& split);
    bool add_direct(const SurfacePass& pass, std::uint64_t seed);
    void add_bounces(const SurfacePass& pass, const Turn& turn);
    void gather_film(const SurfacePass& pass, const FilmPixels& pixels, const Turn& turn);
    void place_world(const SurfacePass& pass, const FilmPixels& pixels);
    void resume();
    int world_map(double rays) const;
    void solve_world(const Turn& turn);
    double check_length() const;
    int check_paths(double rays_per_path) const;
    void report_bounces();
    bool enough(double pace);
    SurfacePass pass(int index) const;
    Turn turn(int index) const;
    void cover_world(const FilmPixels& pixels);

    RenderContext& context_;
    int emitters_ = 0;  // shapes whose light is sampled
    PassCourse course_;
    double begun_ = 0;  // when the last pass ended [s]
    Patience patience_;
    PassMean mean_;
    std::unique_ptr<Frame> frame_;  // of the pass in the making
    std::unique_ptr<SurfaceSolver> solver_;
};

}  // namespace pencil
