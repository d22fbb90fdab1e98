#include "dicom/read/open_images.h"

#include <optional>

namespace pdr::dicom {

struct OpenImages::Slot {
    std::once_flag once;
    std::optional<Result<ImageFile>> image;  ///< set by the first thread that passes `once`
};

std::shared_ptr<OpenImages::Slot> OpenImages::slotOf(const std::filesystem::path& name) {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<Slot>& slot = slots_[name];
    if (!slot)
        slot = std::make_shared<Slot>();
    return slot;
}

Result<DecodedSlice> OpenImages::decode(const std::filesystem::path& name, int frame, Padding padding,
                                        const GoOn& goOn) {
    const std::shared_ptr<Slot> slot = slotOf(name);
    std::call_once(slot->once, [&] {
        const Result<NamedBytes> object = source_.open(name);
        slot->image.emplace(object ? ImageFile::open(*object, goOn) : Result<ImageFile>(object.error()));
    });
    const Result<ImageFile>& image = *slot->image;
    if (image && image->frames() > 1)
        return image->decode(frame, padding, unit_);
    {
        const std::lock_guard lock(mutex_);
        slots_.erase(name);
    }
    return image ? image->decode(frame, padding, unit_) : image.error();
}

}  // namespace pdr::dicom
