// Line projection, the thesis' method: one pencil set after the other, each projected to the film (thesis alg. 6.4).
#pragma once

#include <memory>

#include "film/bounce_series.h"
#include "film/frame.h"
#include "film/method.h"
#include "line/field_maps.h"
#include "line/field_view.h"
#include "line/line_check.h"
#include "line/pencil_solver.h"

namespace pencil {

/// UsageError for options that the method cannot serve together.
MethodNeeds line_needs(const Scene& scene, const std::vector<LightForm>& forms, const RenderOptions& options);

/// Steps: film and direct light, then one bounce at a time, until the series has converged or enough bounces are made; the last one closes
/// the series by its tail.
class LineMethod : public Method {
public:
    explicit LineMethod(RenderContext& context) : context_(context) {}

    bool advance() override;
    bool can_look() const override { return field_view_ != nullptr; }
    void look() override;
    std::vector<Layer> snapshot() const override;
    std::vector<Layer> take() override;
    double estimated_error() const override;
    CertifiedError certified_error() const override { return check_.found(); }
    std::vector<std::string> explain() const override;
    std::shared_ptr<PencilField> field() const override;

private:
    bool begin();
    void show_field();
    void show_levels();
    void show_set();
    PencilSet emission_of(const PencilSet& set);
    Buffer<int> visible_buffer() const;
    void find_rooms();
    void make_solver();
    void make_first_set();
    PencilSet next_set(bool direct);
    void project();
    double project_set();
    double progress() const;
    void count_blind(int surfels);
    void close_series();
    void check();

    RenderContext& context_;
    std::unique_ptr<Frame> frame_;
    Buffer<int> visible_;  // pencils that each surfel of the film sees
    std::unique_ptr<FreeSpace> free_space_;
    std::unique_ptr<CandidateSource> candidates_;
    std::unique_ptr<PencilSolver> solver_;
    std::unique_ptr<FieldView> field_view_;  // of a field that is shown
    PencilSet set_;                          // carries order_ in its maps
    int order_ = 0;                          // reflections, 0: emission
    int projected_ = 0;                      // sets so far
    BounceSeries series_;
    LineCheck check_;
    std::unique_ptr<FieldSum> field_sum_;  // of all sets but that of emission, if it is to be kept
};

}  // namespace pencil
