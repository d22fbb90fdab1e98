#include "dicom/read/compressed_image.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "dicom/read/codecs.h"
#include "dicom/read/decoder_warnings.h"
#include "dicom/read/j2k_decoder.h"
#include "dicom/read/jpeg_scan.h"
#include "dicom/read/rle_stream.h"

namespace pdr::dicom {

namespace {

/// Returns all fragments of a compressed image, joined; empty if there are none.
std::vector<std::uint8_t> joinedFragments(DcmDataset& data) {
    std::vector<std::uint8_t> joined;
    DcmElement* element = nullptr;
    DcmPixelSequence* fragments = nullptr;
    if (data.findAndGetElement(DCM_PixelData, element).bad())
        return joined;
    auto* pixels = dynamic_cast<DcmPixelData*>(element);
    if (!pixels || pixels->getEncapsulatedRepresentation(data.getOriginalXfer(), nullptr, fragments).bad())
        return joined;
    // Item 0 is the offset table.
    for (unsigned long i = 1; i < fragments->card(); ++i) {
        DcmPixelItem* fragment = nullptr;
        Uint8* bytes = nullptr;
        if (fragments->getItem(fragment, i).good() && fragment->getUint8Array(bytes).good() && bytes)
            joined.insert(joined.end(), bytes, bytes + fragment->getLength());
    }
    return joined;
}

/// Returns the damage that the stream itself shows, before the decoder reads it.
Text streamDamage(DcmDataset& data, const SliceHeader& header) {
    const std::vector<std::uint8_t> stream = joinedFragments(data);
    if (DcmXfer(data.getOriginalXfer()).getXfer() == EXS_RLELossless)
        return rleDamage(stream, std::size_t(header.columns) * std::size_t(header.rows),
                         header.format.bitsAllocated / 8);
    const JpegStream jpeg = readJpeg(stream);
    if (jpeg.kind == JpegStream::Kind::none || jpeg.size != ivec2(header.columns, header.rows))
        return phrase("it is not of the size that the file's header says");
    return jpegDamage(jpeg);
}

/// Returns how many decoded pixels hold a number that `format` has no room for. Bits above the stored ones may be
/// copies of the sign, or an overlay of old files that declare it (group 6000).
template <class Raw>
std::size_t impossiblePixels(const Raw* raw, std::size_t count, const PixelFormat& format) {
    const unsigned stored = (1u << format.bitsStored) - 1, sign = 1u << (format.bitsStored - 1);
    const unsigned above = ((1u << format.bitsAllocated) - 1) & ~stored;
    return std::size_t(std::count_if(raw, raw + count, [&](Raw pixel) {
        const unsigned upper = pixel & above;
        return upper != 0 && !(format.isSigned && upper == above && (pixel & sign) != 0);
    }));
}

bool hasOverlayInPixels(DcmDataset& data) {
    Uint16 bit = 0;
    return data.findAndGetUint16(DcmTagKey(0x6000, 0x0102), bit).good() && bit > 0;
}

std::size_t impossiblePixels(DcmDataset& data, const Decoding& decoding) {
    const PixelFormat& format = decoding.format;
    if (format.highBit != format.bitsStored - 1 || format.bitsStored == format.bitsAllocated ||
        hasOverlayInPixels(data))
        return 0;
    if (!decoding.words.empty())
        return impossiblePixels(decoding.words.data(), decoding.words.size(), format);
    unsigned long count = 0;
    const Uint16* words = nullptr;
    const Uint8* bytes = nullptr;
    if (format.bitsAllocated == 16 && data.findAndGetUint16Array(DCM_PixelData, words, &count).good() && words)
        return impossiblePixels(words, count, format);
    if (format.bitsAllocated == 8 && data.findAndGetUint8Array(DCM_PixelData, bytes, &count).good() && bytes)
        return impossiblePixels(bytes, count, format);
    return 0;
}

/// Returns the format of a decoded JPEG 2000 image. Where its samples are signed, the stream is believed; else it may
/// hold them in more bits than are stored, and the header says which.
PixelFormat formatOf(const J2kStream& stream, PixelFormat stated) {
    stated.bitsAllocated = 16;
    if (stream.isSigned) {
        stated.bitsStored = stream.precision;
        stated.highBit = stream.precision - 1;
        stated.isSigned = true;
    }
    return stated;
}

Decoding decompressJ2k(DcmDataset& data, const SliceHeader& header) {
    J2kImage image = decodeJ2k(joinedFragments(data), {header.columns, header.rows});
    Decoding decoding{
        {}, formatOf(image.stream, header.format), !image.stream.isReversible, image.isMended, std::move(image.words)};
    if (!image.stream.damage.empty())
        decoding.damage = phrase("the compressed image is damaged: %1", image.stream.damage);
    return decoding;
}

/// Decodes what the toolkit has a decoder for, or nothing if the pixels are not compressed.
Decoding decompressByToolkit(DcmDataset& data, const SliceHeader& header) {
    Decoding decoding{.format = header.format};
    const bool isCompressed = DcmXfer(data.getOriginalXfer()).isEncapsulated();
    if (const Text damage = isCompressed ? streamDamage(data, header) : Text(); !damage.empty()) {
        decoding.damage = phrase("the compressed image is damaged: %1", damage);
        return decoding;
    }
    const DecoderWarnings warnings;
    if (data.chooseRepresentation(EXS_LittleEndianExplicit, nullptr).bad())
        decoding.damage = phrase("the compressed image cannot be decoded");
    else if (isCompressed && warnings.count() > 0)
        decoding.damage = phrase("the compressed image is damaged: its decoder says \"%1\"", warnings.first());
    return decoding;
}

}  // namespace

Decoding decompress(DcmDataset& data, const SliceHeader& header) {
    Decoding decoding =
        isJpeg2000(header.transferSyntaxUid) ? decompressJ2k(data, header) : decompressByToolkit(data, header);
    // Lossy coding may overshoot beside sharp edges without being damaged.
    const bool isExact =
        isCompressed(header.transferSyntaxUid) && !codingIsLossy(header.transferSyntaxUid) && !decoding.hasLost;
    if (!decoding.damage.empty() || !isExact)
        return decoding;
    if (const std::size_t count = impossiblePixels(data, decoding); count > 0)
        decoding.damage = phrase("the compressed image is damaged: %1 of its pixels hold numbers that %2 bits cannot",
                                 count, decoding.format.bitsStored);
    return decoding;
}

}  // namespace pdr::dicom
