#pragma once
/// The order of the list of series: by patient and study, and within a study what a planner wants first.

#include <vector>

#include "dicom/series.h"

namespace pdr::ui {

/// A study as the list shows it.
struct ListedStudy {
    int patient = 1;          ///< number of its patient in the list, from 1
    std::vector<int> series;  ///< indices in ScanResult::series, at least one, as they are listed
};

/// Returns whether the slices lie across the patient: their normal is nearer to the line from feet to head than to the
/// other two axes.
bool isAxial(const VolumeGeometry& geometry);

/// Returns the studies of `scan` in the order of the list. Patients with a series that can be loaded come first, then
/// they ascend by name; of one patient, studies that can be loaded come first, then newer ones. Within a study: axial
/// CT series that can be loaded, others that can be loaded, resampled ones, refused ones, and images that are no
/// volume; among equals, the smaller slice distance first (to 0.01 mm), then more slices, then the lower number.
std::vector<ListedStudy> listedStudies(const dicom::ScanResult& scan);

}  // namespace pdr::ui
