// When a series of bounces ends.
#pragma once

#include "film/bounce_series.h"
#include "options/render_result.h"

namespace pencil {

/// True if the last bounce adds less than `tolerance` of the sum. Also ends a series that does not decrease, or not within many bounces: the
/// statistics then say that it has not converged, and why.
bool series_ended(const BounceSeries& series, double tolerance, RenderStats& stats);

}  // namespace pencil
