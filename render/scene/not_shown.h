#pragma once
/// What an image leaves out of the patient, in words.

#include "render/base/text.h"

namespace pdr {

struct Scene;

/// Returns in sentences what an image of `scene` does not show, or as a ghost only: what its mask hides, and parts with
/// the scene's own curves, by their names: "Hidden: rest of the body, liver. Ghost: muscle." Of many parts a few are
/// named, the others counted. Empty: all is shown.
Text notShown(const Scene& scene);

}  // namespace pdr
