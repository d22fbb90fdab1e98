#include "dicom/segmentation/segmentation.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <new>

#include "dicom/read/file_structure.h"
#include "dicom/read/parsed_object.h"
#include "dicom/read/refusal.h"
#include "dicom/reference.h"
#include "dicom/segmentation/frame_grid.h"
#include "dicom/segmentation/frame_pixels.h"
#include "dicom/segmentation/segments.h"
#include "render/base/errors.h"
#include "render/base/free_memory.h"

namespace pdr::dicom {

namespace {

constexpr const char* kLabelMapStorage = "1.2.840.10008.5.1.4.1.1.66.7";  // newer than the toolkit

Error refusedObject(const NamedBytes& object, const Text& what, const Text& hint) {
    return {what, object.name.string(), hint, ErrorKind::refused};
}

Result<SliceHeader> headerOf(const NamedBytes& object) {
    HeaderRead read = readSliceHeader(object);
    if (read.kind == HeaderRead::Kind::damaged)
        return damagedObject(object, phrase("the file is damaged: %1", read.damage));
    const std::string& kind = read.header.sopClassUid;
    if (read.kind != HeaderRead::Kind::object || (kind != UID_SegmentationStorage && kind != kLabelMapStorage))
        return refusedObject(object, phrase("this is no DICOM segmentation"),
                             phrase("Choose a label map: a DICOM segmentation, NIfTI, NRRD or MetaImage."));
    const SliceHeader& header = read.header;
    if (header.columns < 1 || header.rows < 1 || header.columns > kMaxSide || header.rows > kMaxSide ||
        header.frames < 1 || header.frames > kMaxFrames)
        return damagedObject(object,
                             phrase("it states an impossible size of %1 x %2 pixels", header.columns, header.rows));
    return std::move(read.header);
}

/// Refuses what belongs to another patient or scan.
Result<void> checkOrigin(const NamedBytes& object, const SliceHeader& header, const Segments& segments,
                         const Series& series) {
    const SeriesReference scan = referenceTo(series);
    const Text hint = phrase("Choose the series that it was made on.");
    const bool isOfSeries =
        !scan.seriesUid.empty() && std::ranges::find(segments.seriesUids, scan.seriesUid) != segments.seriesUids.end();
    const bool isInFrame = !scan.frameOfReferenceUid.empty() && header.frameOfReferenceUid == scan.frameOfReferenceUid;
    if (!scan.seriesUid.empty() && !samePatient(header.patient, series.patient))
        return refusedObject(object, phrase("the segmentation names another patient than the scan"), hint);
    if (!scan.frameOfReferenceUid.empty() && !isInFrame)
        return refusedObject(object, phrase("the segmentation has another frame of reference than the scan"), hint);
    if (!scan.seriesUid.empty() && !isInFrame && !isOfSeries)
        return refusedObject(object, phrase("the segmentation does not refer to the scan"), hint);
    return {};
}

/// Fills the labels of a map from the frames of a segmentation.
class SegmentLabels {
  public:
    SegmentLabels(const Segments& segments, const FrameGrid& grid, const FramePixels& pixels, const Progress& progress)
        : segments_(segments), grid_(grid), pixels_(pixels), progress_(progress) {
        const ivec3 size = grid.geometry.size;
        numbers_.resize(std::size_t(size.x) * std::size_t(size.y));
    }

    /// Counts the voxels of each segment. Errors: those of FramePixels; cancelled().
    Result<std::map<int, std::size_t>> count() {
        std::map<int, std::size_t> counts;
        for (std::size_t frame = 0; frame < grid_.slice.size(); ++frame) {
            if (auto ok = readFrame(frame, 0); !ok)
                return ok.error();
            for (const int number : numbers_)
                if (number != 0)
                    ++counts[number];
        }
        return counts;
    }

    /// Writes the labels of the segments into `map`, the largest one first: smaller ones lie in it. Returns the number
    /// of voxels that several segments hold. Errors: those of FramePixels; cancelled().
    Result<std::size_t> fill(const std::map<int, std::size_t>& counts, LabelMap& map) {
        std::map<int, std::uint8_t> labels;
        std::vector<int> order;
        for (const auto& [number, voxels] : counts) {
            labels[number] = std::uint8_t(labels.size() + 1);
            order.push_back(number);
        }
        std::ranges::stable_sort(order, std::greater(), [&](int number) { return counts.at(number); });
        std::vector<std::size_t> frames(grid_.slice.size());
        std::ranges::generate(frames, [n = std::size_t(0)]() mutable { return n++; });
        const auto rank = [&](std::size_t frame) {
            return std::ranges::find(order, segments_.segmentOfFrame[frame]) - order.begin();
        };
        if (segments_.type != SegmentationType::labelMap)
            std::ranges::stable_sort(frames, {}, rank);
        std::size_t several = 0, done = 0;
        for (const std::size_t frame : frames) {
            if (auto ok = readFrame(frame, 0.5 + 0.5 * double(done++) / double(frames.size())); !ok)
                return ok.error();
            std::uint8_t* out = map.labels.data() + std::size_t(grid_.slice[frame]) * numbers_.size();
            for (std::size_t i = 0; i < numbers_.size(); ++i)
                if (numbers_[i] != 0) {
                    const std::uint8_t label = labels[numbers_[i]];
                    several += std::size_t(out[i] != 0 && out[i] != label);
                    out[i] = label;
                }
        }
        return several;
    }

  private:
    /// Reads the segments of a frame's pixels; 0 is none.
    Result<void> readFrame(std::size_t frame, double fraction) {
        if (!progress_(fraction > 0 ? fraction : 0.5 * double(frame) / double(grid_.slice.size()), "reading labels"))
            return cancelled();
        if (auto ok = pixels_.read(int(frame), numbers_); !ok)
            return ok;
        if (segments_.type == SegmentationType::labelMap)
            return {};
        const int least = segments_.type == SegmentationType::binary ? 1 : (segments_.mostFraction + 1) / 2;
        const auto number = std::uint16_t(segments_.segmentOfFrame[frame]);
        std::ranges::transform(numbers_, numbers_.begin(),
                               [&](std::uint16_t value) { return value >= least ? number : std::uint16_t(0); });
        return {};
    }

    const Segments& segments_;
    const FrameGrid& grid_;
    const FramePixels& pixels_;
    const Progress& progress_;
    std::vector<std::uint16_t> numbers_;
};

std::vector<MappedPart> partsOf(const std::map<int, std::size_t>& counts, const Segments& segments) {
    std::vector<MappedPart> parts;
    for (const auto& [number, voxels] : counts) {
        const auto stated = segments.byNumber.find(number);
        const Segment segment = stated == segments.byNumber.end() ? Segment() : stated->second;
        parts.push_back({segment.label.empty() ? standardName(number) : segment.label,
                         segment.colour.value_or(standardColour(number))});
    }
    return parts;
}

Result<LabelMap> labelsOf(const NamedBytes& object, const Segments& segments, const FrameGrid& grid,
                          const FramePixels& pixels, const Progress& progress) {
    const std::size_t needed = grid.geometry.voxelCount();
    if (needed > freeBytes())
        return notEnoughMemoryForVoxels(needed, object.name.string());
    LabelMap map;
    map.geometry = grid.geometry;
    map.source = phrase("a DICOM segmentation");
    map.labels.assign(needed, 0);
    SegmentLabels filling(segments, grid, pixels, progress);
    const auto counts = filling.count();
    if (!counts)
        return counts.error();
    const Text hint = phrase("Choose a label map: a DICOM segmentation, NIfTI, NRRD or MetaImage.");
    if (counts->empty())
        return refusedObject(object, phrase("it marks no voxel"), hint);
    if (counts->size() > LabelMap::kMostParts)
        return refusedObject(object, phrase("it has more than %1 labels", int(LabelMap::kMostParts)), hint);
    const auto several = filling.fill(*counts, map);
    if (!several)
        return several.error();
    map.parts = partsOf(*counts, segments);
    if (*several > 0)
        map.notes.push_back(phrase("voxels that lie in several parts, of which the smallest keeps them: %1", *several));
    const auto isEmpty = [&](const auto& segment) { return segment.first > 0 && !counts->contains(segment.first); };
    if (const auto empty = std::ranges::count_if(segments.byNumber, isEmpty))
        map.notes.push_back(emptyPartsNote(empty));
    return map;
}

Result<LabelMap> readChecked(const NamedBytes& object, const Series& series, const VolumeGeometry& scan,
                             const Progress& progress) {
    const Result<SliceHeader> header = headerOf(object);
    if (!header)
        return header.error();
    DcmFileFormat content;
    if (!parseObject(object, *header, Extent::all, content))
        return damagedObject(object, phrase("its header cannot be read"));
    DcmItem& data = *content.getDataset();
    const Segments segments = readSegments(data, *header);
    if (!segments.type || int(segments.frames.size()) != header->frames ||
        segments.segmentOfFrame.size() != segments.frames.size())
        return damagedObject(object,
                             phrase("it states %1 frames, and describes another number of them", header->frames));
    if (auto ok = checkOrigin(object, *header, segments, series); !ok)
        return ok.error();
    const Result<FrameGrid> grid = gridOfFrames(segments.frames, scan);
    if (!grid)
        return grid.error().in(object.name.string());
    const Result<FramePixels> pixels = FramePixels::open(object, *header, data);
    if (!pixels)
        return pixels.error();
    return labelsOf(object, segments, *grid, *pixels, progress);
}

}  // namespace

Result<LabelMap> readSegmentation(const NamedBytes& object, const Series& series, const VolumeGeometry& scan,
                                  const Progress& progress) {
    try {
        return readChecked(object, series, scan, progress);
    } catch (const std::bad_alloc&) {
        return notEnoughMemory(phrase("to decode it"), object.name.string(), phrase("Close other programs."));
    }
}

}  // namespace pdr::dicom
