#pragma once
/// What is written over an image, in words; the words of cuts and of series are in cut/cut_text.h and series_text.h.

#include <QStringList>
#include <optional>

#include "render/scene/edit/cut_handles.h"

namespace pdr::ui {

/// What an image shows, and what of the patient is missing in it.
struct ImageFacts {
    QString look;              ///< its name
    bool maskAwaited = false;  ///< all is seen, until what the look leaves out is known
    QString notShown;          ///< sentences; empty: nothing is hidden
    Clip clip;
    std::optional<Uncut> uncut;  ///< what `clip` cuts from; none: not known
};

/// "Bones alone (the rest is not yet removed)", where a name promises what is not there yet; else `look`.
QString lookText(const QString& look, bool maskAwaited);

/// For Annotations::texts: look, part and cut, a line each; what there is none of has no line.
QStringList annotationTexts(const ImageFacts& facts);

}  // namespace pdr::ui
