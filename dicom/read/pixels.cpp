#include "dicom/read/pixels.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "dicom/read/codecs.h"
#include "dicom/read/compressed_image.h"
#include "dicom/read/image_file.h"
#include "dicom/read/parsed_object.h"

namespace pdr::dicom {

namespace {

/// Value that some GE scanners store outside the round field of view without declaring it, or while they declare
/// another.
constexpr int kGeOutsideField = -2000;
constexpr double kGeIntercept = -1024.0;

/// Converts the raw bits of a pixel to the number that they store.
class StoredValue {
  public:
    explicit StoredValue(const PixelFormat& format)
        : shift_(format.highBit + 1 - format.bitsStored),
          mask_((1u << format.bitsStored) - 1),
          signBit_(format.isSigned ? 1u << (format.bitsStored - 1) : 0) {}

    int of(unsigned raw) const {
        const unsigned bits = raw >> shift_ & mask_;
        return int(bits ^ signBit_) - int(signBit_);
    }

    /// Converts a padding value, which is written as a number, not as bits of a pixel, and often with the other
    /// signedness.
    int ofPadding(int sixteenBits) const {
        if (signBit_ == 0)
            return sixteenBits;
        const int asSigned = std::int16_t(sixteenBits);
        if (asSigned >= -int(signBit_) && asSigned < int(signBit_))
            return asSigned;
        // These are the bits of a pixel, then, and not a number; what is wider than a pixel stays so and matches none.
        return int(unsigned(sixteenBits) ^ signBit_) - int(signBit_);
    }

  private:
    int shift_;
    unsigned mask_;
    unsigned signBit_;
};

/// The stored values that mean "nothing measured here".
class PaddingRule {
  public:
    PaddingRule(const ValueMeaning& meaning, const StoredValue& stored, Padding padding) {
        if (meaning.paddingValue) {
            const int first = stored.ofPadding(*meaning.paddingValue);
            const int last = meaning.paddingLimit ? stored.ofPadding(*meaning.paddingLimit) : first;
            lowest_ = std::min(first, last);
            highest_ = std::max(first, last);
        }
        geOutside_ = padding == Padding::maskAsAir && meaning.intercept == kGeIntercept && meaning.slope == 1.0;
    }

    bool matches(int stored) const {
        return (stored >= lowest_ && stored <= highest_) || (geOutside_ && stored == kGeOutsideField);
    }

  private:
    int lowest_ = 1, highest_ = 0;
    bool geOutside_ = false;
};

/// Computes HU = stored * slope + intercept, rounded to the nearest.
class Rescale {
  public:
    explicit Rescale(const ValueMeaning& meaning)
        : slope_(meaning.slope.value_or(1.0)), intercept_(meaning.intercept.value_or(0.0)) {
        // True for nearly every CT: no rounding is needed, which takes half of the time.
        isShift_ = slope_ == 1.0 && std::abs(intercept_) < 1e6 && intercept_ == std::floor(intercept_);
        shift_ = isShift_ ? int(intercept_) : 0;
    }

    /// Returns HU, clamped to a million: far beyond what a slice can hold, and nowhere near the end of int.
    int of(int stored) const {
        if (isShift_)
            return stored + shift_;
        return int(std::clamp(std::round(stored * slope_ + intercept_), -1e6, 1e6));
    }

  private:
    double slope_, intercept_;
    bool isShift_ = false;
    int shift_ = 0;
};

template <class Raw>
DecodedSlice toHu(const Raw* raw, const SliceHeader& header, const Decoding& decoding, Padding padding) {
    const StoredValue storedValue(decoding.format);
    const PaddingRule rule(header.meaning, storedValue, padding);
    const Rescale rescale(header.meaning);
    DecodedSlice slice;
    slice.size = {header.columns, header.rows};
    slice.hasLost = decoding.hasLost && !header.isLossy;
    slice.isMended = decoding.isMended;
    slice.hu.resize(std::size_t(header.columns) * std::size_t(header.rows));
    for (std::size_t i = 0; i < slice.hu.size(); ++i) {
        const int stored = storedValue.of(raw[i]);
        const int hu = rescale.of(stored);
        slice.hu[i] = std::int16_t(std::clamp(hu, -32768, 32767));
        if (!rule.matches(stored)) {
            slice.clipped += slice.hu[i] != hu;
            continue;
        }
        if (slice.padding.empty())
            slice.padding.resize(slice.hu.size(), 0);
        slice.padding[i] = 1;
        if (padding == Padding::maskAsAir)
            slice.hu[i] = Volume::kAirHu;
    }
    return slice;
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
        for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
            std::swap(bytes[i], bytes[i + 1]);
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
    const Decoding decoding = decompress(data, header);
    if (!decoding.damage.empty())
        return damagedObject(object, decoding.damage);

    const unsigned long expected = static_cast<unsigned long>(header.columns) * static_cast<unsigned long>(header.rows);
    unsigned long count = 0;
    if (decoding.format.bitsAllocated == 16) {
        const Uint16* raw = nullptr;
        if (data.findAndGetUint16Array(DCM_PixelData, raw, &count).good() && raw && count >= expected)
            return toHu(raw, header, decoding, padding);
    } else {
        const Uint8* raw = nullptr;
        if (data.findAndGetUint8Array(DCM_PixelData, raw, &count).good() && raw && count >= expected)
            return toHu(raw, header, decoding, padding);
    }
    return damagedObject(object, phrase("the image holds fewer pixels than its header says"));
}

Result<DecodedSlice> decodePlainFrame(const NamedBytes& object, const SliceHeader& frame, Padding padding) {
    return frame.format.bitsAllocated == 16 ? readPlainFrame<Uint16>(object, frame, padding)
                                            : readPlainFrame<Uint8>(object, frame, padding);
}

Result<DecodedSlice> decodeSlice(const NamedBytes& object, Padding padding, int frame) {
    const Result<ImageFile> image = ImageFile::open(object);
    return image ? image->decode(frame, padding) : image.error();
}

Result<DecodedSlice> decodeSlice(const SeriesSource& source, const SliceRef& slice, Padding padding) {
    const Result<NamedBytes> object = source.open(slice.file);
    return object ? decodeSlice(*object, padding, slice.frame) : object.error();
}

}  // namespace pdr::dicom
