#pragma once
/// What tests ask of a series that must load.

#include <QtGlobal>
#include <algorithm>

#include "dicom/import.h"

namespace pdr::test {

/// Returns whether the series has a note of that code.
inline bool hasNote(const dicom::Series& series, const std::string& code) {
    return std::ranges::count(series.verdict.notes, code, &dicom::Note::code) > 0;
}

/// Returns the volume of a series; the test ends where it cannot be loaded.
inline Volume loaded(const dicom::Series& series) {
    auto volume = dicom::loadSeries(series, dicom::Padding::maskAsAir, noProgress);
    if (!volume)
        qFatal("%s", volume.error().text().c_str());
    return *std::move(volume);
}

}  // namespace pdr::test
