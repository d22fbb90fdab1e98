#pragma once
/// Looks in the window's language. Files, provenance and what users have named keep the names that they have.

#include <QString>
#include <string>

#include "app/looks/fitted_looks.h"

namespace pdr::app {

/// What the window calls `look`: one of the program's in its language, the user's own as it is.
QString nameText(const NamedLook& look);
/// What the window calls a look by its `title`, as Scene::lookName has it, changed or not: see lookTitle().
QString nameText(const FittedLooks& looks, const std::string& title);
/// What it does not show, in sentences.
QString doesNotShowText(const NamedLook& look);
/// The same of a setup. Of a changed look it holds as long as the same tissue and the same part is seen.
QString doesNotShowText(const FittedLooks& looks, const PictureSetup& setup);
/// A reason of pdr::whyUnsuited(), a clause.
QString unsuitedText(const std::string& reason);

}  // namespace pdr::app
