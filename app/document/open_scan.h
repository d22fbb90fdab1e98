#pragma once
/// The scan that is open in a document, and what has been made of it for images so far: masks of visible parts, the
/// scan with less noise, and parts that a label map or a rule names.

#include <memory>
#include <utility>

#include "app/document/denoised_scan.h"
#include "app/document/known_parts.h"
#include "app/document/part_masks.h"
#include "app/plan/plan.h"
#include "app/scan/hidden_voxels.h"
#include "render/scene/fit_view.h"
#include "render/scene/scene.h"
#include "render/segment/body_parts.h"
#include "render/segment/hidden_table.h"

namespace pdr::app {

class OpenScan {
  public:
    /// No scan is open.
    OpenScan() = default;
    /// `volume`: the scan without its table. `table`: what was hidden. `hidden`: the voxels of the table; null if
    /// nothing is hidden.
    OpenScan(std::shared_ptr<const Volume> volume, segment::HiddenTable table,
             std::shared_ptr<const HiddenVoxels> hidden);

    /// The scan without its table, whatever is shown; null: none is open.
    const std::shared_ptr<const Volume>& volume() const { return volume_; }
    /// Leaves no volume, and returns it. What has been made of it stays.
    std::shared_ptr<const Volume> takeVolume() { return std::exchange(volume_, nullptr); }
    /// The parts of the body that can be shown or hidden; null if no scan is open.
    const std::shared_ptr<const segment::BodyParts>& bodyParts() const { return bodyParts_; }
    /// The part of the scan's grid that the body fills.
    const VolumeGeometry& bodyBox() const { return table_.bodyBox; }
    /// Whether there is a table, or anything else hidden with it, that can be shown or hidden.
    bool hasTable() const { return hidden_ != nullptr; }
    /// The scan with or without its table. With it, it is built anew once nobody holds it any longer.
    std::shared_ptr<const Volume> seen(Table table) const;
    /// Returns what a view is fitted to: the body, or the whole grid if the table is shown.
    Framed framed(Table table) const;

    PartMasks& masks() { return masks_; }
    DenoisedScan& denoised() { return denoised_; }
    KnownParts& parts() { return parts_; }
    const KnownParts& parts() const { return parts_; }

    /// Returns the scene of `plan` on a film of that size [pixels]. Its mask and its parts are those of the plan if
    /// they are known, else those shown so far, and it says so.
    Scene sceneOf(const Plan& plan, ivec2 film);

  private:
    std::shared_ptr<const Volume> shown(const ImageSetup& setup) const;

    std::shared_ptr<const Volume> volume_;
    segment::HiddenTable table_;                     ///< the table that was detected, and the body's box
    std::shared_ptr<const HiddenVoxels> hidden_;     ///< voxels of the table; null if there is none
    mutable std::weak_ptr<const Volume> withTable_;  ///< the scan with its table, as long as someone holds it
    /// The parts of the body in volume_, whether the table is shown or not.
    std::shared_ptr<const segment::BodyParts> bodyParts_;
    PartMasks masks_;
    DenoisedScan denoised_;
    KnownParts parts_;
};

}  // namespace pdr::app
