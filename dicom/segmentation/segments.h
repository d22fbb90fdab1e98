#pragma once
/// What a DICOM segmentation says beside its pixels: its kind, its segments, its frames and the series it is of.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dicom/read/slice_header.h"
#include "render/volume/label_map.h"

class DcmItem;

namespace pdr::dicom {

/// What the pixels of a segmentation mean.
enum class SegmentationType {
    binary,      ///< 1: in the segment of the frame
    fractional,  ///< the share that is in the segment of the frame, up to mostFraction
    labelMap,    ///< the number of the segment
};

/// A segment; what is absent the file does not say.
struct Segment {
    std::string label;                  ///< UTF-8; it may be empty
    std::optional<LabelColour> colour;  ///< as it is to be displayed
};

struct Segments {
    std::optional<SegmentationType> type;  ///< none: another than these
    int mostFraction = 255;
    std::map<int, Segment> byNumber;      ///< numbers from 1 on
    std::vector<SliceHeader> frames;      ///< places, in the order of the file
    std::vector<int> segmentOfFrame;      ///< number of the segment of each frame; 0: not stated
    std::vector<std::string> seriesUids;  ///< series whose images it refers to
};

/// Reads what `data`, the data set of a segmentation with this header, says.
Segments readSegments(DcmItem& data, const SliceHeader& header);

/// Returns the colour of a CIELab value as DICOM writes it: three numbers of 16 bits (PS3.3, C.10.7.1.1). White is D65:
/// the standard says D50, but what 3D Slicer, highdicom and PixelMed write is meant so.
LabelColour fromCieLab(const std::array<std::uint16_t, 3>& lab);

}  // namespace pdr::dicom
