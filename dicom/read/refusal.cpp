#include "dicom/read/refusal.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "dicom/read/codecs.h"
#include "dicom/read/file_structure.h"
#include "render/base/lower_case.h"

namespace pdr::dicom {

namespace {

Refusal unreadable(Text reason) {
    return {Stack::unreadable, std::move(reason)};
}

bool soundFormat(const SliceHeader& header) {
    const PixelFormat& format = header.format;
    const int bits = format.bitsAllocated;
    if (header.realBits != 0)
        return bits == header.realBits;
    // Decoders give at most 16 bits, and which word of 32 is the lower one is known of little endian only.
    const bool isPlain = !isCompressed(header.transferSyntaxUid) && !isBigEndian(header.transferSyntaxUid);
    const bool isKnown = bits == 8 || bits == 16 || (bits == 32 && isPlain);
    return isKnown && format.bitsStored >= 1 && format.bitsStored <= bits && format.highBit >= format.bitsStored - 1 &&
           format.highBit < bits;
}

/// Returns whether images of another modality than CT can be slices of a volume, and say where they lie: exports of
/// cone-beam scanners (OT), 3D angiography (XA), MR, PET, SPECT, and what does not say its modality. Labels and doses
/// are none.
bool isOtherVolume(const SliceHeader& header) {
    constexpr std::array<std::string_view, 6> kModalities{"OT", "XA", "MR", "PT", "NM", ""};
    return std::ranges::find(kModalities, header.series.modality) != kModalities.end() && header.position &&
           header.rowDirection && header.columnDirection && header.spacingMm;
}

/// Returns whether a Rescale Type stands for Hounsfield units. "Houndsfield Unit" is how some writers spell them.
bool namesHu(const std::string& stated) {
    const std::string unit = lowerCase(stated);
    return unit == "hu" || unit.starts_with("hounsfield") || unit.starts_with("houndsfield");
}

}  // namespace

bool isInHu(const SliceHeader& header) {
    const ValueMeaning& meaning = header.meaning;
    const std::string& modality = header.series.modality;
    if (!meaning.quantity.empty())
        return false;
    if (modality == "OT" || modality == "XA" || modality.empty())
        return namesHu(meaning.unit);
    if (modality != "CT")
        return false;
    if (meaning.unit.empty() && !meaning.slope && !meaning.intercept)
        return header.format.isSigned || header.realBits != 0;
    return meaning.unit.empty() || namesHu(meaning.unit);
}

std::optional<Refusal> refusePixels(const SliceHeader& header) {
    if (header.hasPixelsTwice)
        return unreadable(phrase("it holds pixels twice, as floating-point numbers and otherwise"));
    if (header.pixelBytes == 0)
        return Refusal{Stack::notCt, header.series.modality.empty()
                                         ? phrase("no image, but another kind of object")
                                         : phrase("no image, but %1", header.series.modality)};
    if (header.format.samplesPerPixel != 1 || header.format.photometric.rfind("MONOCHROME", 0) != 0)
        return Refusal{Stack::notCt, phrase("a colour image (%1), not a CT slice", header.format.photometric)};
    // The order of bytes in words depends on how the element is written, and no CT is known that needs it.
    const std::string& coding = header.transferSyntaxUid;
    const bool hasSwappedBytes = header.format.bitsAllocated == 8 && isBigEndian(coding);
    const bool isOutOfReach =
        header.hasFrameGroups ? isDeflated(coding) || hasSwappedBytes : hasSwappedBytes && isGeBigEndian(coding);
    if (!canDecode(header.transferSyntaxUid) || isOutOfReach)
        return unreadable(phrase("its pixels are coded as %1, which this version cannot read",
                                 transferSyntaxName(header.transferSyntaxUid)));
    if (header.meaning.isByTable && !header.meaning.table)
        return unreadable(phrase("a table gives its values (Modality LUT Sequence), which this version cannot read"));
    if (header.frames != 1 && !header.hasFrameGroups)
        return unreadable(phrase("it holds %1 frames in one file, and does not say where they lie", header.frames));
    if (header.frames < 1 || header.frames > kMaxFrames)
        return unreadable(
            phrase("it states %1 frames in one file; from 1 to %2 can be read", header.frames, kMaxFrames));
    if (header.columns < 1 || header.rows < 1 || header.columns > kMaxSide || header.rows > kMaxSide)
        return unreadable(phrase("it states an impossible size of %1 x %2 pixels", header.columns, header.rows));
    if (const PixelFormat& format = header.format; !soundFormat(header))
        return unreadable(phrase("its pixel format cannot be read (%1 bits allocated, %2 stored, high bit %3)",
                                 format.bitsAllocated, format.bitsStored, format.highBit));
    const auto bytes = std::uint64_t(header.columns) * std::uint64_t(header.rows) *
                       std::uint64_t(header.format.bitsAllocated / 8) * std::uint64_t(header.frames);
    if (!isCompressed(header.transferSyntaxUid) && header.pixelBytes < bytes)
        return unreadable(phrase("it holds fewer pixels than its size of %1 x %2 says", header.columns, header.rows));
    return {};
}

std::optional<Refusal> refuseSlice(const SliceHeader& header) {
    const std::string& modality = header.series.modality;
    if (header.pixelBytes != 0 && modality != "CT" && !isOtherVolume(header))
        return Refusal{Stack::notCt,
                       modality.empty() ? phrase("it does not say its modality") : phrase("%1, not CT", modality)};
    if (header.imageType.find("LOCALIZER") != std::string::npos)
        return Refusal{Stack::notCt, phrase("a localizer (scout view), not a CT slice")};
    if (std::optional<Refusal> refusal = refusePixels(header))
        return refusal;
    if (header.meaning.rescaleIsBroken)
        return unreadable(phrase("its rescale slope or intercept is no usable number"));
    return {};
}

}  // namespace pdr::dicom
