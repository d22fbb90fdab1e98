#pragma once
/// Keeps objects of many frames open while their frames are decoded.

#include <map>
#include <memory>
#include <mutex>

#include "dicom/read/image_file.h"

namespace pdr::dicom {

/// The images of a source, each opened once if it holds several frames.
class OpenImages {
  public:
    /// Opens nothing yet. `source` must outlive this. `unit`: that of the voxels.
    explicit OpenImages(const SeriesSource& source, ValueUnit unit = {}) : source_(source), unit_(std::move(unit)) {}

    /// Decodes a frame of the object `name`. Errors: those of SeriesSource::open() and ImageFile. Thread-safe; threads
    /// that ask for the same object wait until it is open. `goOn`: see readSliceHeader().
    Result<DecodedSlice> decode(const std::filesystem::path& name, int frame, Padding padding,
                                const GoOn& goOn = always);

  private:
    struct Slot;
    std::shared_ptr<Slot> slotOf(const std::filesystem::path& name);

    const SeriesSource& source_;
    const ValueUnit unit_;
    std::mutex mutex_;
    std::map<std::filesystem::path, std::shared_ptr<Slot>> slots_;  ///< guarded by mutex_
};

}  // namespace pdr::dicom
