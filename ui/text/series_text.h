#pragma once
/// Texts that describe a series on the screen.

#include <QString>
#include <QStringList>

#include "dicom/series.h"

namespace pdr::ui {

/// Returns the series' own description, or a substitute if it has none.
QString seriesTitle(const dicom::Series& series);
/// Returns a text for the title bar, which task lists, screenshots and recordings show: the series' title, or "CT
/// series 3" if there is none or if it contains a part of the patient's name or the ID.
QString windowSubject(const dicom::Series& series);
/// Returns "CT series 3", which reveals nothing about the patient.
QString seriesNumber(const dicom::Series& series);
/// Returns "512 x 512 x 100, 0.90 x 0.90 x 2.50 mm", or as much as is known.
QString seriesFacts(const dicom::Series& series);
/// Returns the date of the series, else of the study, as 2024-01-31; empty if there is none.
QString seriesDate(const dicom::Series& series);
/// Returns a symbol and words: "✓ can be shown", "✗ a slice is missing".
QString verdictText(const dicom::GeometryVerdict& verdict);
/// Returns "Doe, Jane" for "Doe^Jane"; the first of several representations.
QString patientName(const dicom::PatientFacts& patient);

/// Returns "born 1960-05-17 · ID 4711", or as much as is known.
QString patientDetails(const dicom::PatientFacts& patient);
/// Returns the lines that identify the patient on the screen: "Doe, Jane"; "born 1960-05-17 · ID 4711"; "2024-01-31 ·
/// Thorax with contrast". What is not known is left out, except the name.
QStringList patientLines(const dicom::Series& series);

}  // namespace pdr::ui
