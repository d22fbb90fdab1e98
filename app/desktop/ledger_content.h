#pragma once
/// What the window says of the effects' costs, and what its button does about them.

#include "app/document/document.h"
#include "render/session/effect_ledger.h"
#include "ui/accuracy/effect_ledger.h"

namespace pdr::app {

/// A setup without all that nobody would see.
struct LeanSetup {
    PictureSetup setup;
    QStringList leftOut;  ///< phrases: what it leaves out, and by how much the picture changes; empty: nothing
};

/// Of the document, by the effects whose influence is known as the scene is seen now. What a setup cannot do without,
/// as shadows, stays.
LeanSetup leanSetup(const Document& document, const EffectLedger& ledger);

/// The ledger as the panel shows it; nothing without effects. `leftOut`: see LeanSetup.
ui::EffectRows effectRows(const EffectLedger& ledger, const QStringList& leftOut);

}  // namespace pdr::app
