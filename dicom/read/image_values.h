#pragma once
/// Reads the place of an image and the meaning of its values from the item that states them: the object itself, or a
/// functional group of a frame.

#include "dicom/read/slice_header.h"

class DcmItem;

namespace pdr::dicom {

/// Fills position, directions and spacing as far as `item` states them.
void readPlane(DcmItem& item, SliceHeader& header);

/// Fills slope, intercept and unit, or the table that gives the values and its unit.
void readRescale(DcmItem& item, ValueMeaning& meaning);

/// Fills the name of the unit of values that are no HU: that of a real-world value mapping in `item` (PS3.3,
/// C.7.6.16.2.11) if it leads to the same values as the rescale, which must have been read.
void readUnitName(DcmItem& item, ValueMeaning& meaning);

/// Returns the first window that `item` states.
StatedWindow readWindow(DcmItem& item);

}  // namespace pdr::dicom
