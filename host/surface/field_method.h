// The light of a field of pencils by surface pencils: what the texels of its maps see is lit by the light samples and by a world set. The field is
// the mean of passes, each with a world set of its own: noise and errors of places both fall with their number.
#pragma once

#include <memory>
#include <vector>

#include "film/method.h"
#include "film/render_context.h"
#include "surface/surface_pass.h"
#include "surface/surface_solver.h"

namespace pencil {

/// Steps: one pass each, RenderOptions::field_rays of them. There is no image; RenderOptions::field names the pencils.
class FieldMethod : public Method {
public:
    explicit FieldMethod(RenderContext& context);

    bool advance() override;
    std::vector<Layer> snapshot() const override { return {}; }
    std::shared_ptr<PencilField> field() const override;
    std::vector<std::string> explain() const override;

private:
    void make_solver(std::uint64_t seed);
    void gather(std::uint64_t seed);
    void add(int first, int count, const Surfels& seen, const Buffer<float>& radiance);
    SurfacePencils seeds() const;

    RenderContext& context_;
    const PencilField& target_;
    SurfacePass pass_;
    std::vector<glm::vec3> centres_;  // [scene units]
    SurfacePencils pencils_;          // of the field, for the order in which their texels are seen
    std::unique_ptr<SurfaceSolver> solver_;
    std::vector<double> sum_;  // of all passes, as PencilField::light
    int passes_ = 0;
    bool whole_ = false;  // no pass is half done
};

}  // namespace pencil
