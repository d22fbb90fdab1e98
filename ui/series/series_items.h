#pragma once
/// The rows of the series list, with what is said in them. Their roles are in series_delegate.h.

#include <QStandardItemModel>
#include <QString>
#include <vector>

#include "dicom/series.h"

namespace pdr::ui {

/// Replaces the rows of `model` by those of `scan`: a heading for each study, and below it its series. Returns the row
/// of each series, by its index in the scan.
std::vector<int> fillSeriesModel(QStandardItemModel& model, const dicom::ScanResult& scan);

/// Sets what the rows say of patients: names, or if `namesHidden`, numbers.
void namePatients(QStandardItemModel& model, bool namesHidden);

bool hasSeveralPatients(const QStandardItemModel& model);

/// Returns what the row says for the patient's name: the name, or if `namesHidden`, "Patient 2 (name hidden)".
QString patientOf(const QModelIndex& row, bool namesHidden);

}  // namespace pdr::ui
