#pragma once
/// What a look is called that the user has changed: "Bone (changed)".

#include <string>

namespace pdr::app {

/// `name` of a look, changed or not, as it is called once it is changed.
std::string changedName(const std::string& name);
/// `name` of a look, changed or not, as it was called before.
std::string unchangedName(const std::string& name);

}  // namespace pdr::app
