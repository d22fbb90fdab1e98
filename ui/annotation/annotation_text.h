#pragma once
/// The texts of an image's annotations. Cuts are described by ui/text/cut_text.h, series by ui/text/series_text.h.

#include <QStringList>
#include <optional>

#include "render/scene/edit/cut_handles.h"

namespace pdr::ui {

/// What an image shows, and which parts of the patient are missing in it.
struct ImageFacts {
    QString look;              ///< name of the look
    bool maskAwaited = false;  ///< the image shows everything until the mask of the look is known
    QString notShown;          ///< what is hidden, in sentences; empty: nothing is hidden
    Clip clip;
    std::optional<Uncut> uncut;  ///< the box that `clip` cuts from; none: not known
    bool ctDenoised = false;     ///< whether it shows the scan with less noise
};

/// Returns "Bones alone (the rest is not yet removed)" while the mask that the look's name promises is missing; else
/// `look`.
QString lookText(const QString& look, bool maskAwaited);

/// Returns the lines for Annotations::texts: look, hidden parts, cut, and that the scan is denoised, one line each.
/// Empty ones are left out.
QStringList annotationTexts(const ImageFacts& facts);

}  // namespace pdr::ui
