#include "line/field_view.h"

#include "line/field_maps.h"
#include "line/weights.h"

namespace pencil {

FieldView::FieldView(RenderContext& context, PencilSolver& solver, FreeSpace& space)
    : context_(context), solver_(solver), space_(space), centres_(field_centres(*context.options.field, context.flat)) {
    const RenderOptions& options = context.options;
    context.stats.field_pencils = context.stats.field_read = options.field->count();
    if (shows_part(options)) subset_ = std::make_unique<FieldSubset>(*options.field, *options.field_source, centres_, options.pencils);
}

void FieldView::show(const Surfels& film, PencilSet& set) {
    if (subset_) return show_part(film, set);
    if (lit_) return;
    set = solver_.create_at(centres_);
    light(*context_.options.field, set);
}

void FieldView::show_part(const Surfels& film, PencilSet& set) {
    std::vector<int> changed;
    context_.clock.run("choose pencils", [&] { changed = subset_->choose(context_.kernels, context_.device_scene, film); });
    context_.stats.field_read = subset_->read();
    if (lit_ && changed.empty() && share_ == subset_->share()) return;
    space_.set_share(share_ = subset_->share());
    if (!lit_)
        set = solver_.create_at(subset_->centres(changed));
    else if (!changed.empty())
        solver_.replace(set, changed, subset_->centres(changed));
    light(subset_->chosen(), set);
}

/// The light of a field with the same centres, and weights.
void FieldView::light(const PencilField& field, PencilSet& set) {
    const double unit = context_.flat.normalisation.light;
    if (context_.maps_emit) {
        solver_.fill(set, nullptr, true, false, true);
        context_.clock.run("field", [&] { add_field(field, unit, set); });
    } else {
        solver_.weigh(set);
        context_.clock.run("field", [&] { set_field(field, unit, weights_in_maps(context_.kernels.features().weights), set); });
    }
    lit_ = true;
}

}  // namespace pencil
