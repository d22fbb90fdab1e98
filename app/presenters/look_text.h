#pragma once
/// Texts of looks in the window's language. Files, provenance and the user's own looks keep their original names.

#include <QString>
#include <string>

#include "app/looks/fitted_looks.h"

namespace pdr::app {

/// Returns the window's name of `look`: translated for bundled looks, as it is for the user's own.
QString nameText(const NamedLook& look);
/// Returns the window's name of a look, changed or not, by its `title` as in Scene::lookName; see lookTitle().
QString nameText(const FittedLooks& looks, const std::string& title);
/// Returns what `look` does not show, in sentences.
QString doesNotShowText(const NamedLook& look);
/// Returns what a setup does not show, in sentences; empty unless it shows the same tissue and part, with the same
/// model, as the look that it began with.
QString doesNotShowText(const FittedLooks& looks, const ImageSetup& setup);
/// Returns a reason given by pdr::whyUnsuited(), a clause, in the window's language; empty for none.
QString unsuitedText(const std::string& reason);

}  // namespace pdr::app
