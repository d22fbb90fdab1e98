#pragma once
/// The masks of one volume's visible parts that were made last, and the one that is shown.

#include <deque>
#include <memory>

#include "render/scene/visible.h"
#include "render/volume/mask.h"

namespace pdr::app {

class PartMasks {
  public:
    /// Takes the mask of `visible`. Only the newest masks are kept, for undo.
    void add(const Visible& visible, std::shared_ptr<const Mask> mask);
    /// Shows `visible` if its mask is known or if it needs none; otherwise the mask shown so far stays.
    void show(const Visible& visible);
    /// The choice that is shown; all of the patient at first.
    const Visible& shown() const { return shown_.visible; }
    /// The mask that is shown; null if all of the patient is.
    const std::shared_ptr<const Mask>& mask() const { return shown_.mask; }

  private:
    struct PartMask {
        Visible visible;
        std::shared_ptr<const Mask> mask;
    };

    std::deque<PartMask> known_;  ///< the newest last
    PartMask shown_;
};

}  // namespace pdr::app
