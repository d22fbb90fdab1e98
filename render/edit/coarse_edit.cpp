#include "render/edit/coarse_edit.h"

#include <utility>

#include "render/denoise/resampled.h"
#include "render/edit/light_change.h"
#include "render/edit/mixture.h"

namespace pdr {

using denoise::Colours;
using denoise::Plane;
using denoise::reduced;

CoarseEdit::CoarseEdit(std::shared_ptr<const KeptImage> old, ivec2 size, FirstSamples before)
    : old_(std::move(old)),
      reduced_{reduced(old_->all[0], size), reduced(old_->all[1], size), reduced(old_->all[2], size)},
      before_(std::move(before)),
      dim_(dimOf(old_->all)) {}

/// The old image shares no noise with the coarse films, whose random numbers are others: it counts whole for each half.
Colours CoarseEdit::radiance(const FirstSamples& after, std::uint64_t mark) const {
    const HalfImages& samples = *after.at(mark);
    const HalfImages was = smoothed(*before_.at(mark), mark), is = smoothed(samples, mark);
    const LightChange even = changeBetween(was.even, is.even, dim_), odd = changeBetween(was.odd, is.odd, dim_);
    const Plane part = shareOfChange({reduced_, reduced_}, {laidOn(reduced_, even), laidOn(reduced_, odd)}, dim_);
    const SmoothHalves laid{laidOn(reduced_, partOf(even, part)), laidOn(reduced_, partOf(odd, part))};
    const Plane share = shareOfSecond(laid, {is.even, is.odd}, samples.even, samples.odd, dim_, pixelsAlike(mark));
    const Colours fresh = meanOf(is.even, is.odd);
    const LightChange all = partOf(changeBetween(meanOf(was.even, was.odd), fresh, dim_), part);
    return laidOn(old_->all, mixed(share, all, fresh));
}

}  // namespace pdr
