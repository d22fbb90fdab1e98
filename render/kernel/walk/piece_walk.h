#pragma once
/// Traversal of the cells between voxels along a ray and, in each cell, of the linear pieces of the curve. The borders
/// of pieces are found exactly: there is no step length. On each segment the HU are a cubic polynomial, and extinction
/// and source are linear in them.

#include "render/kernel/walk/cell_walk.h"
#include "render/kernel/walk/parted_optics.h"

namespace pdr {

/// A ray segment inside one cell and one piece of the curve.
template <class Real>
struct PieceOfWay {
    OpticsPiece<Real> piece;
    Cubic<Real> hu;
    Real begin;   ///< mm from the ray's origin
    Real length;  ///< mm
};

/// A segment with its visibility weight, for scenes with a mask.
template <class Real>
struct MaskedPieceOfWay : PieceOfWay<Real> {
    Cubic<Real> weight;  ///< in [0, 1]
};

/// A segment with the mixture of its curves, for scenes with parts.
template <class Real>
struct PartedPieceOfWay : MaskedPieceOfWay<Real> {
    bool masked;  ///< whether there is a mask; without one `weight` is not set
    MixedAlong<Real> mixed;
};

/// Returns the mean of the visible extinction along a segment of a walk in tissue of that kind [1/mm].
template <Tissue Kind, class Real, class Way>
PDR_HD_INLINE Real meanExtinctionOn(const OpticsAlong<Real>& along, const Way& way) {
    if constexpr (Kind == Tissue::parted)
        return PartedExtinction<Real>{along, way.hu, way.weight, way.masked, way.mixed}.mean();
    else if constexpr (Kind == Tissue::masked)
        return seenAlong(along, way.weight).meanExtinction;
    else
        return along.meanExtinction;
}

/// The segments of a walk, of a cell and of a piece, in tissue of a kind.
template <class Real, Tissue Kind>
struct WayOf {
    using InCell = HuAlong<Real>;
    using InPiece = PieceOfWay<Real>;
};
template <class Real>
struct WayOf<Real, Tissue::masked> {
    using InCell = MaskedHuAlong<Real>;
    using InPiece = MaskedPieceOfWay<Real>;
};
template <class Real>
struct WayOf<Real, Tissue::parted> {
    using InCell = PartedHuAlong<Real>;
    using InPiece = PartedPieceOfWay<Real>;
};

/// Walks along a ray segment by segment. Kind: the scene's tissue; code for masks and parts is compiled only where it
/// says so. Cells: CellWalk, or ThinWalk, of which some segments are looks.
template <class Real, Tissue Kind, class Cells = CellWalk<Real>>
class PieceWalk {
  public:
    using Int = typename SimdTraits<Real>::Int;
    using Mask = typename SimdTraits<Real>::Mask;
    using Way = typename WayOf<Real, Kind>::InPiece;

    /// `random`: what Cells need of random numbers.
    template <class... Random>
    PDR_HD_INLINE void start(const FlatMajorants& grid, const Vec3<Real>& origin, const Vec3<Real>& direction,
                             Real length, const Random&... random) {
        cells_.start(grid, origin, direction, length, random...);
    }
    PDR_HD Cells& cells() { return cells_; }

    PDR_HD Mask going() const { return cells_.walking() | (inCell_.length > 0.0f); }
    PDR_HD void stop(Mask mask) {
        cells_.stop(mask);
        inCell_.length = mask ? Real{} : inCell_.length;
    }
    /// Returns the lanes in which a segment could not be made short enough. From there on all segments are passed,
    /// whatever `pass` returns.
    PDR_HD Mask exceeded() const { return exceeded_ > 0.0f; }

    /// Makes one step: lanes that look for tissue move to the next cell, then all lanes in tissue advance, including
    /// those that have just met it. pass(way, ready, forced) returns the lanes that accept `way`, out of those in
    /// `ready`; where `forced` holds, all must accept. The segment of the others is halved.
    template <class Pass>
    PDR_HD_INLINE void step(const FlatScene& scene, Pass&& pass) {
        const Mask seeking = cells_.walking() & !(inCell_.length > 0.0f);
        if (any(seeking))
            seek(scene, seeking);
        const Mask inCell = inCell_.length > 0.0f;
        if (any(inCell))
            goOn(scene, inCell, pass);
    }

    /// Starts lane l, where `mask` holds, on the ray of lane from[l] of `other`, which has been started but not
    /// stepped.
    void take(Mask mask, const PieceWalk& other, Int from) {
        cells_.take(mask, other.cells_, from);
        inCell_.length = mask ? Real{} : inCell_.length;
        reach_ = mask ? Real{} + 1.0f : reach_;
        exceeded_ = mask ? Real{} : exceeded_;
    }

  private:
    static constexpr float kShortest = 0x1p-24f;  ///< fraction of a cell's segment below which it is not halved

    /// Moves to the next cell between voxels, and skips it if it is transparent or hidden.
    PDR_HD_INLINE void seek(const FlatScene& scene, Mask seeking) {
        // A look that finds nothing counts, too.
        const Mask met = cells_.step(scene, seeking, inCell_) & !cells_.looking();
        const Mask clear =
            (inCell_.hu.highest() < scene.optics.clearUpTo) | (inCell_.hu.lowest() >= scene.optics.clearFrom);
        inCell_.length = (met & clear) ? Real{} : inCell_.length;
        if constexpr (Kind != Tissue::whole)
            if (hasWeights(scene))
                inCell_.length = (met & !(inCell_.weight.highest() > 0.0f)) ? Real{} : inCell_.length;
    }

    /// Passes the next segment through the current cell.
    template <class Pass>
    PDR_HD_INLINE void goOn(const FlatScene& scene, Mask inCell, Pass&& pass) {
        // Take the next part of the cell's segment and the piece that it begins in.
        Cubic<Real> before, behind;
        inCell_.hu.split(reach_, before, behind);
        [[maybe_unused]] CornerPieces<Real> corners;  // known where a cell has several curves
        const OpticsPiece<Real> piece = beginOf(scene, inCell, before, corners);
        const float rounding = scene.optics.rounding;
        const Mask fits = (before.lowest() >= piece.start - rounding) & (before.highest() <= piece.end + rounding);
        // Shorten it to the border of the piece, if it crosses one.
        const Mask crosses = unfolded(inCell & !fits & before.monotone());
        Real reach = reach_;
        if (any(crosses)) {
            const Real border = before.b3 < before.b0 ? piece.start : piece.end;
            const Real fraction = reach_ * before.whereIs(border, crosses);
            reach = crosses ? fraction : reach_;
            inCell_.hu.split(reach, before, behind);
            before.b3 = crosses ? border : before.b3;
            behind.b0 = crosses ? border : behind.b0;
        }
        // Offer it to `pass`.
        exceeded_ = (inCell & (reach_ <= kShortest)) ? Real{} + 1.0f : exceeded_;
        const Mask ready = inCell & (fits | crosses | exceeded());
        const Real length = inCell_.length * reach;
        Way way{};
        way.piece = piece;
        way.hu = before;
        way.begin = cells_.reached() - inCell_.length;
        way.length = length;
        [[maybe_unused]] Cubic<Real> weightBehind{};
        if constexpr (Kind != Tissue::whole)
            if (hasWeights(scene))
                inCell_.weight.split(reach, way.weight, weightBehind);
        [[maybe_unused]] Vec3<Real> middle{};
        if constexpr (Kind == Tissue::parted) {
            way.masked = isMasked(scene);
            const Mask several = inCell & (inCell_.curve == kSeveralCurves);
            if (any(several)) {
                middle = between(inCell_.begin, inCell_.end, reach);
                mix(corners, several, inCell_.begin, middle, way.mixed);
            }
        }
        const Mask gone = ready & pass(way, ready, exceeded());
        // Continue behind it where it was accepted; halve it elsewhere.
        reach_ = inCell ? (gone ? Real{} + 1.0f : 0.5f * reach) : reach_;
        reach_ = max(reach_, Real{} + kShortest);
        const Mask split = gone & (reach < 1.0f);
        inCell_.hu.take(split, behind);
        if constexpr (Kind != Tissue::whole)
            if (hasWeights(scene))
                inCell_.weight.take(split, weightBehind);
        if constexpr (Kind == Tissue::parted)
            if (any(way.mixed.several))
                pdr::take(inCell_.begin, split, middle);
        inCell_.length = gone ? inCell_.length - length : inCell_.length;
    }

    PDR_HD static bool hasWeights(const FlatScene& scene) {
        return Kind == Tissue::masked || (Kind == Tissue::parted && isMasked(scene));
    }
    /// Returns the piece that the segment `hu` begins in.
    PDR_HD_INLINE OpticsPiece<Real> beginOf(const FlatScene& scene, [[maybe_unused]] Mask inCell, const Cubic<Real>& hu,
                                            [[maybe_unused]] CornerPieces<Real>& corners) const {
        if constexpr (Kind == Tissue::parted)
            return pieceAtBegin(scene, inCell_, inCell, hu, corners);
        else
            return pieceAtBegin(scene.optics, scene.transferFunction, hu);
    }
    PDR_HD_INLINE static Vec3<Real> between(const Vec3<Real>& from, const Vec3<Real>& to, Real s) {
        return {from.x + (to.x - from.x) * s, from.y + (to.y - from.y) * s, from.z + (to.z - from.z) * s};
    }

    Cells cells_;
    typename WayOf<Real, Kind>::InCell inCell_{};  ///< rest of the segment through the current cell
    Real reach_ = Real{} + 1.0f;                   ///< fraction of this rest that is tried next
    Real exceeded_{};                              ///< 1: a segment reached the shortest length
};

}  // namespace pdr
