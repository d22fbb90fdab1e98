#include "dicom/refusal.h"

#include "dicom/codecs.h"

namespace pdr::dicom {

namespace {

Refusal unreadable(std::string reason) {
    return {Stack::unreadable, std::move(reason)};
}

bool soundFormat(const PixelFormat& format) {
    const int bits = format.bitsAllocated;
    return (bits == 8 || bits == 16) && format.bitsStored >= 1 && format.bitsStored <= bits &&
           format.highBit >= format.bitsStored - 1 && format.highBit < bits;
}

std::string formatText(const PixelFormat& format) {
    return std::to_string(format.bitsAllocated) + " bits allocated, " + std::to_string(format.bitsStored) +
           " stored, high bit " + std::to_string(format.highBit);
}

}  // namespace

std::optional<Refusal> refusePixels(const SliceHeader& header) {
    if (header.pixelBytes == 0)
        return Refusal{Stack::notCt, "no image, but " + (header.series.modality.empty() ? "another kind of object"
                                                                                        : header.series.modality)};
    if (header.format.samplesPerPixel != 1 || header.format.photometric.rfind("MONOCHROME", 0) != 0)
        return Refusal{Stack::notCt, "a colour picture (" + header.format.photometric + "), not a CT slice"};
    if (!canDecode(header.transferSyntaxUid))
        return unreadable("its pixels are coded as " + transferSyntaxName(header.transferSyntaxUid) +
                          ", which this version cannot read");
    if (header.frames != 1)
        return unreadable("it holds " + std::to_string(header.frames) +
                          " frames in one file (enhanced or multi-frame), which this version cannot read");
    if (header.columns < 1 || header.rows < 1 || header.columns > kMaxSide || header.rows > kMaxSide)
        return unreadable("it states an impossible size of " + std::to_string(header.columns) + " x " +
                          std::to_string(header.rows) + " pixels");
    if (!soundFormat(header.format))
        return unreadable("its pixel format cannot be read (" + formatText(header.format) + ")");
    const auto bytes = std::uint64_t(header.columns) * std::uint64_t(header.rows) * (header.format.bitsAllocated / 8);
    if (!isCompressed(header.transferSyntaxUid) && header.pixelBytes < bytes)
        return unreadable("it holds fewer pixels than its size of " + std::to_string(header.columns) + " x " +
                          std::to_string(header.rows) + " says");
    return {};
}

std::optional<Refusal> refuseSlice(const SliceHeader& header) {
    const std::string& modality = header.series.modality;
    if (header.pixelBytes != 0 && modality != "CT")
        return Refusal{Stack::notCt, modality.empty() ? "it does not say its modality" : modality + ", not CT"};
    if (header.imageType.find("LOCALIZER") != std::string::npos)
        return Refusal{Stack::notCt, "a localizer (scout view), not a CT slice"};
    if (std::optional<Refusal> refusal = refusePixels(header))
        return refusal;
    if (header.meaning.rescaleIsBroken)
        return unreadable("its rescale slope or intercept is no usable number");
    return {};
}

}  // namespace pdr::dicom
