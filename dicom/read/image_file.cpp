#include "dicom/read/image_file.h"

#include <memory>
#include <new>
#include <optional>
#include <span>
#include <utility>

#include "dicom/read/codecs.h"
#include "dicom/read/frame_object.h"
#include "dicom/read/refusal.h"
#include "render/base/errors.h"
#include "render/base/plain_file.h"

namespace pdr::dicom {

namespace {

template <class Work>
auto withinMemory(const NamedBytes& object, Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return notEnoughMemory(phrase("to decode it"), object.name.string(), phrase("Close other programs."));
    }
}

/// Returns whether the only image of an object lies in its bytes as it is, so that the toolkit, which would copy it,
/// need not read it. Words of 16 bits and floating-point numbers may have their high byte first.
bool isPlain(const SliceHeader& header) {
    const std::string& coding = header.transferSyntaxUid;
    const bool isOrdered = !isBigEndian(coding) || header.format.bitsAllocated == 16 || header.realBits != 0;
    return !isCompressed(coding) && !isDeflated(coding) && isOrdered;
}

/// Returns the rescale to voxels of `unit`. Steps of a voxel and of a stored number may be the same: then no rounding
/// may come between them.
ValueMeaning inVoxels(ValueMeaning meaning, const ValueUnit& unit) {
    const double shift = unit.voxelOf(meaning.intercept.value_or(0));
    meaning.slope = meaning.slope.value_or(1) / unit.step;
    meaning.intercept = std::abs(*meaning.slope) == 1 ? std::round(shift) : shift;
    return meaning;
}

}  // namespace

Result<void> ImageFile::readChecked(const GoOn& goOn) {
    HeaderRead read = readSliceHeader(object_, goOn);
    if (read.kind != HeaderRead::Kind::object)
        return damagedObject(object_, read.damage.empty() ? phrase("this is no DICOM image")
                                                          : phrase("the file is damaged: %1", read.damage));
    header_ = std::move(read.header);
    frames_ = std::move(read.frames);
    if (const std::optional<Refusal> refusal = refusePixels(header_))
        return Error{refusal->reason, object_.name.string(), ""};
    if (frames_.empty() || !isCompressed(header_.transferSyntaxUid))
        return {};
    ByteSource source(object_);
    fragments_ = fragmentsOfFrames(source, readFragments(source, header_.pixelsAt), header_.frames);
    if (fragments_.empty())
        return damagedObject(object_,
                             phrase("nothing says where each of its %1 compressed frames begins", header_.frames));
    return {};
}

Result<ImageFile> ImageFile::open(const NamedBytes& object, const GoOn& goOn) {
    ImageFile image;
    image.object_ = object;
    if (!object.memory) {
        std::error_code failure;
        if (!std::filesystem::exists(object.name, failure))
            return Error{phrase("the file is no longer there"), object.name.string(), phrase("Open the folder again.")};
        if (auto ok = checkPlainFile(object.name); !ok)
            return ok.error();
        image.state_ = stateOf(object.name);
    }
    if (auto ok = withinMemory(object, [&] { return image.readChecked(goOn); }); !ok)
        return ok.error();
    return image;
}

Result<DecodedSlice> ImageFile::decodeCodedFrame(const SliceHeader& frame, Padding padding) const {
    std::vector<std::uint8_t> stream;
    ByteSource source(object_);
    for (const Fragment& fragment : fragments_[std::size_t(frame.frame)]) {
        const std::size_t before = stream.size();
        stream.resize(before + fragment.bytes);
        if (!source.read(fragment.at, std::span(stream).subspan(before)))
            return damagedObject(object_, phrase("the image holds fewer pixels than its header says"));
    }
    SliceHeader alone = frame;
    alone.hasMetaHeader = false;
    const auto bytes = std::make_shared<const std::vector<std::uint8_t>>(frameObject(alone, stream));
    return decodePixels({object_.name, bytes}, alone, padding);
}

Result<DecodedSlice> ImageFile::decodeFrame(const SliceHeader& frame, Padding padding) const {
    if (frame.meaning.rescaleIsBroken)
        return damagedObject(object_, phrase("its rescale slope or intercept is no usable number"));
    if (frames_.empty() && !isPlain(frame))
        return decodePixels(object_, frame, padding);
    if (!fragments_.empty())
        return decodeCodedFrame(frame, padding);
    return decodePlainFrame(object_, frame, padding);
}

Result<DecodedSlice> ImageFile::decode(int frame, Padding padding, const ValueUnit& unit) const {
    const auto count = frames_.empty() ? 1 : int(frames_.size());
    if (frame < 0 || frame >= count)
        return changedFile(object_.name);
    SliceHeader header = frames_.empty() ? header_ : frames_[std::size_t(frame)];
    if (!unit.isHu)
        header.meaning = inVoxels(header.meaning, unit);
    Result<DecodedSlice> decoded = withinMemory(object_, [&] { return decodeFrame(header, padding); });
    if (decoded)
        decoded->identity = identityOf(header);
    return object_.memory || stateOf(object_.name) == state_ ? std::move(decoded) : changedFile(object_.name);
}

}  // namespace pdr::dicom
