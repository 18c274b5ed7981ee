// Indirect light by pencils on surfaces: a world set for all bounces, film pencils that gather from it, and the film lit by them. An image
// is the mean of passes, which grow finer: noise and interpolation error both fall with time.
#pragma once

#include <memory>

#include "certify/error_check.h"
#include "film/frame.h"
#include "film/layer_mean.h"
#include "film/method.h"
#include "surface/film_pencils.h"
#include "surface/patience.h"
#include "surface/surface_pass.h"
#include "surface/surface_solver.h"

namespace pencil {

/// Hierarchy and rays; no maps.
MethodNeeds surface_needs(const Scene& scene, const std::vector<LightForm>& forms, const RenderOptions& options);

/// Steps: one pass each, until time or the estimated error tell to stop. The image is the mean of the passes.
class SurfaceMethod : public Method {
public:
    explicit SurfaceMethod(RenderContext& context);

    bool advance() override;
    std::vector<Layer> snapshot() const override;
    std::vector<Layer> take() override;
    double estimated_error() const override;
    CertifiedError certified_error() const override;
    std::vector<std::string> explain() const override;

private:
    bool add_pass(const SurfacePass& pass);
    bool add_direct(const SurfacePass& pass, std::uint64_t seed);
    void add_bounces(const SurfacePass& pass, const Turn& turn);
    void place_world(const SurfacePass& pass, const FilmPixels& pixels);
    int world_map() const;
    double check_length() const;
    int check_paths(double rays_per_path) const;
    void report_bounces();
    bool enough(double pace);
    const LayerMean& shown(LayerMean& copy) const;
    bool spreads_outliers() const;
    double spread_of(const LayerMean& mean) const;
    double error_of(double spread, const CertifiedError& certified) const;
    CertifiedError certify(const LayerMean& mean) const;
    SurfacePass pass(int index) const;
    SurfacePencils seeds(const FilmPixels& pixels) const;

    RenderContext& context_;
    int emitters_ = 0;      // shapes whose light is sampled
    int index_ = 0;         // of the next pass
    double film_rays_ = 0;  // of the last one
    double begun_ = 0;      // when the last pass ended [s]
    Patience patience_;
    LayerMean mean_;
    ErrorCheck check_;
    std::unique_ptr<Frame> frame_;  // of the pass in the making
    int world_set_ = -1;            // of the solver
    int world_wish_ = 1;            // pencils that it asked for
    std::unique_ptr<SurfaceSolver> solver_;
};

}  // namespace pencil
