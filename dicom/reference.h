#pragma once
/// References to the images of a series, as other DICOM objects state them: reports, segmentations and presentation
/// states (PS3.3, table 10-11).

#include <string>
#include <vector>

#include "dicom/series.h"

namespace pdr::dicom {

/// One image of a series. An empty UID is absent or malformed: no other object can refer to the image.
struct ImageReference {
    std::string classUid, instanceUid;
    int frame = 1;  ///< number of the frame, from 1; an object states it only if the image has several frames

    bool isComplete() const { return !classUid.empty() && !instanceUid.empty(); }
};

/// The images of a series and where they belong. An empty UID is absent or malformed. UIDs lead to the patient: they
/// may only go into DICOM objects of the same study.
struct SeriesReference {
    std::string studyUid;   ///< empty: no object can be added to the study
    std::string seriesUid;  ///< empty: no object can refer to any of the images
    /// The frame of reference of all positions. Also empty where the slices name several: no object can state a
    /// position in the patient then, and no other series is known to share the coordinates.
    std::string frameOfReferenceUid;
    /// One for each slice, in their order. Slices that share an instance UID (and frame) have none: it would be a guess
    /// which of them is meant.
    std::vector<ImageReference> images;
};

/// Returns the references to the slices of `series`.
SeriesReference referenceTo(const Series& series);

}  // namespace pdr::dicom
