#include "dicom/read/pixels.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <span>
#include <type_traits>
#include <utility>

#include "dicom/read/codecs.h"
#include "dicom/read/compressed_image.h"
#include "dicom/read/image_file.h"
#include "dicom/read/open_images.h"
#include "dicom/read/parsed_object.h"
#include "dicom/read/stored_pixels.h"

namespace pdr::dicom {

namespace {

/// Reads the pixels of Float Pixel Data or Double Float Pixel Data (PS3.3, C.7.6.24 and C.7.6.25).
Result<DecodedSlice> decodeReals(const NamedBytes& object, DcmDataset& data, const SliceHeader& header,
                                 Padding padding) {
    const auto expected = static_cast<unsigned long>(header.columns) * static_cast<unsigned long>(header.rows);
    unsigned long count = 0;
    const Float32* single = nullptr;
    if (data.findAndGetFloat32Array(DCM_FloatPixelData, single, &count).good() && single && count >= expected)
        return realsToHu(single, header, padding);
    const Float64* twice = nullptr;
    if (data.findAndGetFloat64Array(DCM_DoubleFloatPixelData, twice, &count).good() && twice && count >= expected)
        return realsToHu(twice, header, padding);
    return damagedObject(object, phrase("the image holds fewer pixels than its header says"));
}

/// Returns pixels of 32 bits, of which the toolkit knows the words, the lower one first.
std::vector<Uint32> joinedWords(const Uint16* words, std::size_t pixels) {
    std::vector<Uint32> joined(pixels);
    for (std::size_t i = 0; i < pixels; ++i)
        joined[i] = words[2 * i] | Uint32(words[2 * i + 1]) << 16;
    return joined;
}

/// Reads the pixels of a frame that is not compressed, and lies in the object as it is.
template <class Raw>
Result<DecodedSlice> readPlainFrame(const NamedBytes& object, const SliceHeader& frame, Padding padding) {
    std::vector<Raw> raw(std::size_t(frame.columns) * std::size_t(frame.rows));
    const std::span bytes(reinterpret_cast<std::uint8_t*>(raw.data()), raw.size() * sizeof(Raw));
    ByteSource source(object);
    if (!source.read(frame.pixelsAt + std::uint64_t(frame.frame) * bytes.size(), bytes))
        return damagedObject(object, phrase("the image holds fewer pixels than its header says"));
    if (isBigEndian(frame.transferSyntaxUid))
        for (std::size_t i = 0; i < bytes.size(); i += sizeof(Raw))
            std::ranges::reverse(bytes.subspan(i, sizeof(Raw)));
    if constexpr (std::is_floating_point_v<Raw>)
        return realsToHu(raw.data(), frame, padding);
    else
        return toHu(raw.data(), frame, Decoding{.format = frame.format}, padding);
}

}  // namespace

Error damagedObject(const NamedBytes& object, Text what) {
    return {std::move(what), object.name.string(), phrase("Copy the file again from its source.")};
}

Error changedFile(const std::filesystem::path& file) {
    return {phrase("the file has changed since the folder was scanned"), file.string(),
            phrase("Open the folder again: it may hold another patient's images now."), ErrorKind::refused};
}

Result<DecodedSlice> decodePixels(const NamedBytes& object, const SliceHeader& header, Padding padding) {
    DcmFileFormat content;
    if (!parseObject(object, header, Extent::all, content))
        return damagedObject(object, phrase("the file is damaged: it cannot be parsed to its end"));
    DcmDataset& data = *content.getDataset();
    if (header.realBits != 0)
        return decodeReals(object, data, header, padding);
    const Decoding decoding = decompress(data, header);
    if (!decoding.damage.empty())
        return damagedObject(object, decoding.damage);
    if (!decoding.words.empty())
        return toHu(decoding.words.data(), header, decoding, padding);

    const unsigned long expected = static_cast<unsigned long>(header.columns) * static_cast<unsigned long>(header.rows);
    unsigned long count = 0;
    if (decoding.format.bitsAllocated > 8) {
        const bool isWide = decoding.format.bitsAllocated == 32;
        const Uint16* raw = nullptr;
        if (data.findAndGetUint16Array(DCM_PixelData, raw, &count).good() && raw &&
            count >= expected * (isWide ? 2 : 1))
            return isWide ? toHu(joinedWords(raw, expected).data(), header, decoding, padding)
                          : toHu(raw, header, decoding, padding);
    } else {
        const Uint8* raw = nullptr;
        if (data.findAndGetUint8Array(DCM_PixelData, raw, &count).good() && raw && count >= expected)
            return toHu(raw, header, decoding, padding);
    }
    return damagedObject(object, phrase("the image holds fewer pixels than its header says"));
}

Result<DecodedSlice> decodePlainFrame(const NamedBytes& object, const SliceHeader& frame, Padding padding) {
    if (frame.realBits != 0)
        return frame.realBits == 32 ? readPlainFrame<float>(object, frame, padding)
                                    : readPlainFrame<double>(object, frame, padding);
    switch (frame.format.bitsAllocated) {
        case 8:
            return readPlainFrame<Uint8>(object, frame, padding);
        case 16:
            return readPlainFrame<Uint16>(object, frame, padding);
        default:
            return readPlainFrame<Uint32>(object, frame, padding);
    }
}

Result<DecodedSlice> decodeSlice(const NamedBytes& object, Padding padding, int frame) {
    const Result<ImageFile> image = ImageFile::open(object);
    return image ? image->decode(frame, padding) : image.error();
}

Result<DecodedSlice> decodeSlice(const Series& series, const SliceRef& slice, Padding padding) {
    return OpenImages(*series.source, series.unit).decode(slice.file, slice.frame, padding);
}

}  // namespace pdr::dicom
