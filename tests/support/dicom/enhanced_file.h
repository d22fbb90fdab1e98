#pragma once
/// Writes small multi-frame CT images for tests, right or deliberately wrong.

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "dicom/read/codecs.h"
#include "tests/support/dicom/damaged_streams.h"

namespace pdr::test {

/// One frame: axial, pixels of 1 mm, twelve bits unsigned.
struct EnhancedFrame {
    dvec3 position{0, 0, 0};
    double slope = 1, intercept = -1024;
    int temporalIndex = 1;
    std::string stackId = "1";
    std::vector<std::uint16_t> raw;
    std::function<void(DcmItem&)> change;  ///< alters the item of the frame
};

struct EnhancedFile {
    ivec2 size{16, 12};
    std::vector<EnhancedFrame> frames;
    std::string seriesUid = "1.2.3.9";
    std::function<void(DcmDataset&)> change;
};

/// Returns the item of a sequence, which is made if it is not there.
inline DcmItem& itemIn(DcmItem& parent, const DcmTagKey& sequence, long index = 0) {
    DcmItem* item = nullptr;
    if (parent.findOrCreateSequenceItem(sequence, item, index).bad())
        qFatal("the test cannot make an item");
    return *item;
}

/// Describes `frames` in the groups of `data`; spacing and directions are shared.
inline void describeFrames(DcmDataset& data, const std::vector<EnhancedFrame>& frames) {
    char text[100];
    DcmItem& shared = itemIn(data, DCM_SharedFunctionalGroupsSequence);
    itemIn(shared, DCM_PlaneOrientationSequence).putAndInsertString(DCM_ImageOrientationPatient, "1\\0\\0\\0\\1\\0");
    itemIn(shared, DCM_PixelMeasuresSequence).putAndInsertString(DCM_PixelSpacing, "1\\1");
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const EnhancedFrame& frame = frames[k];
        DcmItem& own = itemIn(data, DCM_PerFrameFunctionalGroupsSequence, long(k));
        std::snprintf(text, sizeof text, "%.6g\\%.6g\\%.6g", frame.position.x, frame.position.y, frame.position.z);
        itemIn(own, DCM_PlanePositionSequence).putAndInsertString(DCM_ImagePositionPatient, text);
        DcmItem& content = itemIn(own, DCM_FrameContentSequence);
        content.putAndInsertString(DCM_StackID, frame.stackId.c_str());
        content.putAndInsertUint32(DCM_TemporalPositionIndex, Uint32(frame.temporalIndex));
        DcmItem& rescale = itemIn(own, DCM_PixelValueTransformationSequence);
        std::snprintf(text, sizeof text, "%.6g", frame.slope);
        rescale.putAndInsertString(DCM_RescaleSlope, text);
        std::snprintf(text, sizeof text, "%.6g", frame.intercept);
        rescale.putAndInsertString(DCM_RescaleIntercept, text);
        rescale.putAndInsertString(DCM_RescaleType, "HU");
        if (frame.change)
            frame.change(own);
    }
}

/// Fills everything but the pixels.
inline void describeEnhanced(DcmDataset& data, const EnhancedFile& file) {
    char uid[100];
    data.putAndInsertString(DCM_SOPClassUID, UID_EnhancedCTImageStorage);
    data.putAndInsertString(DCM_SOPInstanceUID, dcmGenerateUniqueIdentifier(uid));
    data.putAndInsertString(DCM_StudyInstanceUID, "1.2.3");
    data.putAndInsertString(DCM_SeriesInstanceUID, file.seriesUid.c_str());
    data.putAndInsertString(DCM_Modality, "CT");
    data.putAndInsertString(DCM_ImageType, "ORIGINAL\\PRIMARY\\VOLUME\\NONE");
    data.putAndInsertString(DCM_PhotometricInterpretation, "MONOCHROME2");
    data.putAndInsertUint16(DCM_SamplesPerPixel, 1);
    data.putAndInsertString(DCM_NumberOfFrames, std::to_string(file.frames.size()).c_str());
    data.putAndInsertUint16(DCM_Columns, Uint16(file.size.x));
    data.putAndInsertUint16(DCM_Rows, Uint16(file.size.y));
    data.putAndInsertUint16(DCM_BitsAllocated, 16);
    data.putAndInsertUint16(DCM_BitsStored, 12);
    data.putAndInsertUint16(DCM_HighBit, 11);
    data.putAndInsertUint16(DCM_PixelRepresentation, 0);
    describeFrames(data, file.frames);
}

/// Writes `file` with raw pixels.
inline void writeEnhancedFile(const std::filesystem::path& path, const EnhancedFile& file,
                              E_TransferSyntax coding = EXS_LittleEndianExplicit) {
    dicom::prepareToolkit();
    DcmFileFormat content;
    DcmDataset& data = *content.getDataset();
    describeEnhanced(data, file);
    std::vector<std::uint16_t> raw;
    for (const EnhancedFrame& frame : file.frames)
        raw.insert(raw.end(), frame.raw.begin(), frame.raw.end());
    data.putAndInsertUint16Array(DCM_PixelData, raw.data(), static_cast<unsigned long>(raw.size()));
    if (file.change)
        file.change(data);
    if (content.saveFile(path.c_str(), coding).bad())
        qFatal("the test cannot write its file");
}

/// How the compressed frames of a file lie in it.
struct Fragmenting {
    int perFrame = 1;  ///< number of fragments of each frame
    bool hasTable = false;
    std::size_t besides = 0;        ///< what is added to the offsets of the table, to make them wrong [bytes]
    bool hasExtendedTable = false;  ///< whether offsets and lengths of 64 bits lie in elements of their own
};

/// Adds an element of 64-bit numbers.
inline void addNumbers(DcmDataset& data, const DcmTagKey& tag, const std::vector<Uint64>& numbers) {
    auto* element = new DcmOther64bitVeryLong(tag);
    element->putUint64Array(numbers.data(), static_cast<unsigned long>(numbers.size()));
    data.insert(element, true);
}

/// Writes `file` with `streams`, one for each frame, as its pixels.
inline void writeCodedEnhancedFile(const std::filesystem::path& path, const EnhancedFile& file,
                                   const std::vector<std::string>& streams, E_TransferSyntax coding,
                                   const Fragmenting& how) {
    dicom::prepareToolkit();
    DcmFileFormat content;
    DcmDataset& data = *content.getDataset();
    describeEnhanced(data, file);
    auto* sequence = new DcmPixelSequence(DCM_PixelSequenceTag);
    auto* table = new DcmPixelItem(DCM_PixelItemTag);
    sequence->insert(table);
    std::vector<Uint8> offsets;
    std::vector<Uint64> longOffsets, lengths;
    std::size_t at = 0;
    for (const std::string& stream : streams) {
        longOffsets.push_back(at);
        lengths.push_back(stream.size());
        for (int shift = 0; shift < 32; shift += 8)
            offsets.push_back(Uint8((at + how.besides) >> shift));
        const std::size_t length = (stream.size() / std::size_t(how.perFrame) + 1) / 2 * 2;
        for (int part = 0; part < how.perFrame; ++part) {
            const std::size_t first = std::size_t(part) * length;
            std::string bytes = stream.substr(first, part + 1 < how.perFrame ? length : std::string::npos);
            bytes.resize((bytes.size() + 1) / 2 * 2);
            auto* fragment = new DcmPixelItem(DCM_PixelItemTag);
            fragment->putUint8Array(reinterpret_cast<const Uint8*>(bytes.data()),
                                    static_cast<unsigned long>(bytes.size()));
            sequence->insert(fragment);
            at += 8 + bytes.size();
        }
    }
    if (how.hasTable)
        table->putUint8Array(offsets.data(), static_cast<unsigned long>(offsets.size()));
    if (how.hasExtendedTable) {
        addNumbers(data, DCM_ExtendedOffsetTable, longOffsets);
        addNumbers(data, DCM_ExtendedOffsetTableLengths, lengths);
    }
    auto* pixels = new DcmPixelData(DCM_PixelData);
    pixels->putOriginalRepresentation(coding, nullptr, sequence);
    data.insert(pixels, true);
    if (file.change)
        file.change(data);
    if (content.saveFile(path.c_str(), coding).bad())
        qFatal("the test cannot write its file");
}

/// Alters `data` so that its pixels, `raw`, have eight bits.
inline void putEightBits(DcmDataset& data, const std::vector<std::uint16_t>& raw) {
    data.putAndInsertUint16(DCM_BitsAllocated, 8);
    data.putAndInsertUint16(DCM_BitsStored, 8);
    data.putAndInsertUint16(DCM_HighBit, 7);
    const std::vector<Uint8> bytes(raw.begin(), raw.end());
    if (!bytes.empty())
        data.putAndInsertUint8Array(DCM_PixelData, bytes.data(), static_cast<unsigned long>(bytes.size()));
}

/// Returns the stream of one compressed frame of twelve bits, or eight; `scratch` is overwritten by a file of that
/// frame alone.
inline std::string streamOf(const std::filesystem::path& scratch, ivec2 size, const std::vector<std::uint16_t>& raw,
                            E_TransferSyntax coding, int bits = 12) {
    SliceFile slice{.size = size, .raw = raw, .isSigned = false, .bitsStored = 12};
    if (bits == 8)
        slice.change = [&raw](DcmDataset& data) { putEightBits(data, raw); };
    if (!writeCompressedSlice(scratch, slice, coding))
        qFatal("the test cannot encode a frame");
    const std::string bytes = bytesOf(scratch);
    const StreamRange range = streamRange(bytes);
    return bytes.substr(range.first, range.last - range.first);
}

}  // namespace pdr::test
