#pragma once
/// A series in words for the screen.

#include <QString>
#include <QStringList>

#include "dicom/series.h"

namespace pdr::ui {

/// The series' own description, or what stands for it when it has none.
QString seriesTitle(const dicom::Series& series);
/// What a title bar may say, which task lists, screenshots and recordings show: the series' title, or "CT series 3"
/// where there is none, or where a part of the patient's name or the ID stands in it.
QString windowSubject(const dicom::Series& series);
/// "CT series 3", which tells nothing of the patient.
QString seriesNumber(const dicom::Series& series);
/// "512 x 512 x 100, 0.90 x 0.90 x 2.50 mm", or as much as is known.
QString seriesFacts(const dicom::Series& series);
/// The day of the series, else of the study, as 2024-01-31; empty when there is none.
QString seriesDate(const dicom::Series& series);
/// A symbol and words: "✓ can be shown", "✗ a slice is missing".
QString verdictText(const dicom::GeometryVerdict& verdict);
/// "Doe, Jane" for "Doe^Jane"; the first of several writings.
QString patientName(const dicom::PatientFacts& patient);

/// "born 1960-05-17 · ID 4711", as much of it as is known.
QString patientDetails(const dicom::PatientFacts& patient);
/// Whose series it is, for the screen, a line each: "Doe, Jane"; "born 1960-05-17 · ID 4711"; "2024-01-31 · Thorax with
/// contrast". What is not known is left out, but for the name.
QStringList patientLines(const dicom::Series& series);

}  // namespace pdr::ui
