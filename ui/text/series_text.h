#pragma once
/// Texts that describe a series on the screen.

#include <QString>
#include <QStringList>

#include "dicom/series.h"

namespace pdr::ui {

/// Returns the series' own description, or a substitute if it has none.
QString seriesName(const dicom::Series& series);
/// Returns that name and, behind it, the phase: "Thorax · acquisition 2".
QString seriesTitle(const dicom::Series& series);
/// Returns a text for the title bar, which task lists, screenshots and recordings show: the series' title, or "CT
/// series 3" if there is none, if it contains a part of the patient's name or the ID, or if it is a file's name.
QString windowSubject(const dicom::Series& series);
/// Returns "CT series 3", or "MR series 3", which reveals nothing about the patient.
QString seriesNumber(const dicom::Series& series);
/// Returns lines that describe the images of a series, or as much as is known: "100 slices · 2.50 mm", the
/// distance of their planes, if it can be loaded, behind a modality other than CT; the phase; "512 × 512 · JPEG 2000".
QStringList seriesFacts(const dicom::Series& series);
/// Returns the date and the description of the study of `series`: "2024-01-31 · Follow-up"; the date alone if names are
/// hidden, since descriptions sometimes contain them. Empty if nothing is stated.
QString studyText(const dicom::Series& series, bool namesHidden);
/// Returns "Doe, Jane" for "Doe^Jane"; the first of several representations.
QString patientName(const dicom::PatientFacts& patient);

/// Returns "born 1960-05-17 · ID 4711", or as much as is known.
QString patientDetails(const dicom::PatientFacts& patient);
/// Returns the lines that identify the patient on the screen: "Doe, Jane"; "born 1960-05-17 · ID 4711"; "2024-01-31 ·
/// Thorax with contrast". What is not known is left out, except the name.
QStringList patientLines(const dicom::Series& series);

}  // namespace pdr::ui
