#pragma once
/// Curves that a few numbers say, from 0 to `top`.

#include "render/scene/edit/curve.h"

namespace pdr {

/// A ramp around `level`, as wide as `width` >= 0: 0 below it, `top` above.
Curve windowCurve(float level, float width, float top);
/// A step: `top` from `hu` on.
Curve thresholdCurve(float hu, float top);
/// A raised cosine around `centre`, in eight straight pieces: `width` > 0 is where it is half as high.
Curve bellCurve(float centre, float width, float top);

}  // namespace pdr
