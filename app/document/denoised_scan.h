#pragma once
/// The scan with less noise that was made last, and the voxels that it was made of. Only the image shows it.

#include <memory>
#include <utility>

#include "render/volume/volume.h"

namespace pdr::app {

class DenoisedScan {
  public:
    /// Takes `denoised`, which was made of `scan`, in place of the one before. It is kept for undo, too.
    void take(std::shared_ptr<const Volume> scan, std::shared_ptr<const Volume> denoised) {
        scan_ = std::move(scan);
        denoised_ = std::move(denoised);
    }
    /// Returns `scan` with less noise; null if it is not known.
    std::shared_ptr<const Volume> of(const std::shared_ptr<const Volume>& scan) const {
        return scan == scan_ ? denoised_ : nullptr;
    }

  private:
    std::shared_ptr<const Volume> scan_, denoised_;
};

}  // namespace pdr::app
