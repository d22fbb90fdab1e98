#pragma once
/// A series in words for the screen.

#include <QString>

#include "dicom/series.h"

namespace pdr::ui {

/// The series' own description, or what stands for it when it has none.
QString seriesTitle(const dicom::Series& series);
/// What a title bar may say, which task lists, screenshots and recordings show: "CT series 3". No free text, since
/// people write names into descriptions.
QString windowSubject(const dicom::Series& series);
/// "512 x 512 x 100, 0.90 x 0.90 x 2.50 mm", or as much as is known.
QString seriesFacts(const dicom::Series& series);
/// The day of the series, else of the study, as 2024-01-31; empty when there is none.
QString seriesDate(const dicom::Series& series);
/// A symbol and words: "✓ can be shown", "✗ a slice is missing".
QString verdictText(const dicom::GeometryVerdict& verdict);
/// "Doe, Jane" for "Doe^Jane"; the first of several writings.
QString patientName(const dicom::PatientFacts& patient);

}  // namespace pdr::ui
