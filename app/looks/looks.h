#pragma once
/// The looks that are bundled with the programs.

#include <vector>

#include "render/base/result.h"
#include "render/scene/named_look.h"

namespace pdr::app {

/// Returns the bundled looks in the order in which they are offered. The first one that suits a scan is its default:
/// Bone, or with contrast in the blood, the look that shows what is bone without contrast.
Result<std::vector<NamedLook>> bundledLooks();

/// Returns whether the brightness of the model's images should follow the tissue. An X-ray on a bright ground and the
/// window of a maximum intensity projection define white themselves.
bool followsTissue(Model model);

}  // namespace pdr::app
