#pragma once
/// Curves that are defined by a few numbers, with values from 0 to `top`.

#include "render/scene/edit/curve.h"

namespace pdr {

/// Returns a ramp around `level`, as wide as `width` >= 0: 0 below it, `top` above.
Curve windowCurve(float level, float width, float top);
/// Returns a step: `top` from `hu` on.
Curve thresholdCurve(float hu, float top);
/// Returns a raised cosine around `centre`, in eight straight pieces; `width` > 0 is its width at half its height.
Curve bellCurve(float centre, float width, float top);

}  // namespace pdr
