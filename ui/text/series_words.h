#pragma once
/// What is said of a series' verdict in one or few words.

#include <QString>
#include <vector>

#include "dicom/series.h"

namespace pdr::ui {

/// Returns what is unusual about a series that can be loaded, in one word, by the gravest of its notes: "lossy" before
/// "copies". Empty if there are no notes.
QString unusualWord(const std::vector<dicom::Note>& notes);

/// Returns a symbol and words: "✓  can be shown"; with notes, the word for the gravest: "✓  lossy"; for a series that
/// is refused: "✗  a slice is missing".
QString verdictText(const dicom::GeometryVerdict& verdict);

}  // namespace pdr::ui
