#pragma once
/// Parts of a patient that an image can show alone or leave out, as masks with smooth edges. Rules of density and
/// geometry, without learning or atlas: crude, and each states what it misses.
///   peeled   all that lies deeper below the body's surface than so many mm
///   lungs    air inside the body, at least 150 ml and not pure gas as in bowel, with the vessels in it (closed by 8
///            mm), without the outermost 5 mm, where fat and pleura shine through
///   bones    cells connected to dense bone that are no blood with contrast medium (bone_cells.h): marrow and blood may
///            have the same HU, so that no transfer function separates them

#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/segment/body_mask.h"
#include "render/segment/smooth_distance.h"
#include "render/volume/mask.h"
#include "render/volume/volume.h"

namespace pdr::segment {

using PartMask = Result<std::shared_ptr<const Mask>>;

/// Whether a part is shown alone, or all but that part.
enum class Use { shown, hidden };

/// A result that is computed once, unless that is refused or cancelled; threads take turns.
template <typename T>
struct Found {
    std::mutex mutex;
    std::shared_ptr<const T> value;
};

/// The parts of one volume. What several parts need is computed once, by the first caller; others wait for it. Errors:
/// those of bodyMask(); of kind refused, why a part cannot be identified; else cancelled().
class BodyParts {
  public:
    explicit BodyParts(std::shared_ptr<const Volume> volume) : volume_(std::move(volume)) {}

    const Volume& volume() const { return *volume_; }

    /// The masks of the parts. `on`: the voxels that the mask is for: the volume's own, or other ones in the same
    /// patient. `depthMm`: [0, 50].
    PartMask peeled(double depthMm, const VolumeGeometry& on, const Progress& progress) const;
    PartMask lungs(Use use, const VolumeGeometry& on, const Progress& progress) const;
    PartMask bones(Use use, const VolumeGeometry& on, const Progress& progress) const;
    /// Returns the mask of the part with that label (labels.h); an error of kind refused if there is no such part.
    PartMask labelled(std::string_view label, Use use, const VolumeGeometry& on, const Progress& progress) const;

    /// Frees most of the memory of the results, for when many parts have been requested and few will be soon. The next
    /// ones take a little longer then.
    void forgetDistances() const;

  private:
    using Distance = Result<std::shared_ptr<const SmoothDistance>>;
    using FoundCells = Result<std::shared_ptr<const Cells>>;  ///< at least one of them is 1

    Result<std::shared_ptr<const BodyMask>> body(const Progress& progress) const;
    /// Returns distances from the skin inwards, known as far as `depthMm`.
    Distance belowSkin(double depthMm, const Progress& progress) const;
    /// Returns distances from the surface of the lungs, widened by their vessels, inwards.
    Distance inLungs(const Progress& progress) const;
    /// Returns distances from the bones outwards.
    Distance fromBones(const Progress& progress) const;
    /// Returns the cells of the lungs and their vessels.
    FoundCells aroundLungs(const BodyMask& body, const Progress& progress) const;
    FoundCells cellsOfBones(const CellGrid& grid, const Progress& progress) const;
    template <typename WeightOf>
    PartMask maskOn(const VolumeGeometry& on, const Distance& distance, Text hidden, const Progress& progress,
                    const WeightOf& weightOf) const;

    std::shared_ptr<const Volume> volume_;
    mutable Found<BodyMask> body_;  ///< without `shown` and `cut`
    mutable Found<Cells> aroundLungs_, bones_;
    /// Distances, which take four times the memory of their cells. Of either pair the last one requested is kept: a
    /// peel and a part may be requested together.
    mutable Found<SmoothDistance> belowSkin_, deepBelowSkin_, inLungs_, fromBones_;
};

}  // namespace pdr::segment
