#pragma once
/// Label maps from DICOM segmentations (PS3.3, A.51): binary, fractional, and label maps; one segment or many.

#include "dicom/series.h"
#include "render/base/named_bytes.h"
#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/label_map.h"

namespace pdr::dicom {

/// Reads the segments of `object` as parts, on the grid of its own frames. `scan`: the voxels that they are for;
/// `series`: what these were read from. A part has the label and the recommended colour of its segment; where a segment
/// is fractional, what is half of it or more belongs to it. Of voxels in several segments the smallest one keeps them,
/// which a note says. Errors, of kind refused if not said otherwise: no segmentation, damaged, or coded as none that is
/// read; of another patient or frame of reference than `series`; frames that lie in no even grid; more than 255
/// segments with voxels, or none; not enough memory; cancelled().
Result<LabelMap> readSegmentation(const NamedBytes& object, const Series& series, const VolumeGeometry& scan,
                                  const Progress& progress);

}  // namespace pdr::dicom
