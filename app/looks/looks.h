#pragma once
/// The looks that the programs carry inside them.

#include <vector>

#include "render/base/result.h"
#include "render/scene/named_look.h"

namespace pdr::app {

/// In the order in which they are offered. The first one that makes sense of a scan is its default: Bone, or where
/// there is contrast in the blood, what is bone without it.
Result<std::vector<NamedLook>> bundledLooks();

/// Whether the brightness of the model's pictures is to follow the tissue; an X-ray on a bright ground and the window
/// of a maximum say themselves what is white.
bool followsTissue(Model model);

}  // namespace pdr::app
