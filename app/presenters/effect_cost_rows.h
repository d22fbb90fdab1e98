#pragma once
/// The panel of the effects' costs: its rows, and the setup without the effects that nobody would see.

#include "app/document/document.h"
#include "render/session/effect_costs.h"
#include "ui/accuracy/effect_costs.h"

namespace pdr::app {

/// A setup without the effects whose absence nobody would see.
struct LeanSetup {
    ImageSetup setup;
    QStringList leftOut;  ///< phrases: what it leaves out, and by how much the image changes; empty if nothing
};

/// Returns the lean setup of the document, by the effects whose influence has been measured for the current view.
/// Effects that a setup cannot turn off, such as shadows, stay.
LeanSetup leanSetup(const Document& document, const EffectCosts& effectCosts);

/// Returns the cost table as the panel shows it; empty without effects. `leftOut`: see LeanSetup.
ui::EffectRows effectRows(const EffectCosts& effectCosts, const QStringList& leftOut);

}  // namespace pdr::app
