#pragma once
/// What the light under a point of the image says, as a sentence.

#include "render/base/text.h"
#include "render/prepare/layers_under.h"

namespace pdr {

/// Returns why the point shows no place, or what was left out where its heaviest layer is taken out of a choice; empty
/// for a place, which needs no words.
Text layersText(const LayersUnder& under);

}  // namespace pdr
