#pragma once
/// Remarks on the image of a frame, and the name of its file.

#include <QStringList>

#include "app/presenters/workspace.h"

namespace pdr::app {

/// Returns the remarks on a denoised image; nothing for another.
QStringList denoisedTexts(const Frame& frame);

/// Returns remarks on what may mislead about the image: comparison modes, stretching and known bias; or that no bias is
/// known. `view`: the size at which the image is shown [screen pixels].
QStringList remarksOn(const Frame& frame, QSize view);

/// Returns a file name, "Bones-alone_A_2030-01-31": look, visible side, today. It contains nothing of the patient.
QString fileNameOf(const FittedLooks& looks, const Frame& frame);

}  // namespace pdr::app
