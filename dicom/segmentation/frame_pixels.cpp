#include "dicom/segmentation/frame_pixels.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include "dicom/read/codecs.h"

namespace pdr::dicom {

namespace {

Error refusedPixels(const NamedBytes& object, const Text& what) {
    return {what, object.name.string(), phrase("Export the segmentation anew, without compression."),
            ErrorKind::refused};
}

/// Returns the bytes of pixels that are not compressed, as they lie in a file with the low byte first.
std::span<const std::uint8_t> plainBytes(DcmItem& data) {
    const Uint8* bytes = nullptr;
    unsigned long count = 0;
    if (data.findAndGetUint8Array(DCM_PixelData, bytes, &count).bad() || !bytes)
        return {};
    return {bytes, count};
}

}  // namespace

Result<FramePixels> FramePixels::open(const NamedBytes& object, const SliceHeader& header, DcmItem& data) {
    const int bits = header.format.bitsAllocated;
    const bool isWhole = bits == 8 || bits == 16;
    const std::string& coding = header.transferSyntaxUid;
    if (header.format.samplesPerPixel != 1 || (bits != 1 && !isWhole))
        return refusedPixels(object, phrase("its pixels are no segments (%1 bits)", bits));
    if ((isCompressed(coding) && !isWhole) || isBigEndian(coding))
        return refusedPixels(
            object, phrase("its pixels are coded as %1, which this version cannot read", transferSyntaxName(coding)));
    if (isCompressed(coding)) {
        auto image = ImageFile::open(object);
        if (!image)
            return image.error();
        FramePixels pixels(bits, {});
        pixels.coded_.push_back(*std::move(image));
        return pixels;
    }
    const std::span<const std::uint8_t> bytes = plainBytes(data);
    const std::uint64_t pixels =
        std::uint64_t(header.columns) * std::uint64_t(header.rows) * std::uint64_t(header.frames);
    if (bytes.size() < (pixels * std::uint64_t(bits) + 7) / 8)
        return damagedObject(object, phrase("the image holds fewer pixels than its header says"));
    return FramePixels(bits, bytes);
}

Result<void> FramePixels::read(int frame, std::span<std::uint16_t> out) const {
    if (!coded_.empty()) {
        const Result<DecodedSlice> slice = coded_.front().decode(frame, Padding::keep);
        if (!slice)
            return slice.error();
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] = std::uint16_t(slice->hu[i]);
        return {};
    }
    const std::size_t first = std::size_t(frame) * out.size();
    for (std::size_t i = 0; i < out.size(); ++i) {
        const std::size_t at = first + i;
        // Pixels of one bit follow each other without gaps between rows or frames, the lowest bit first (PS3.5, 8.1.1).
        if (bits_ == 1)
            out[i] = bytes_[at / 8] >> (at % 8) & 1;
        else
            out[i] = bits_ == 8 ? bytes_[at] : std::uint16_t(bytes_[2 * at] | bytes_[2 * at + 1] << 8);
    }
    return {};
}

}  // namespace pdr::dicom
