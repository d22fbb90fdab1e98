#include "render/edit/coarse_edit.h"

#include <utility>

#include "render/denoise/resampled.h"
#include "render/edit/foretold.h"
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
    const std::optional<Colours> gain = foretoldGain(before_, after);
    const Colours old = withGain(gain, reduced_);
    const HalfImages was = smoothedForChange(withGain(gain, *before_.at(mark)), mark),
                     is = smoothedForChange(samples, mark);
    const LightChange even = changeBetween(was.even, is.even, dim_), odd = changeBetween(was.odd, is.odd, dim_);
    const Plane part = shareOfChange({old, old}, {laidOn(old, even), laidOn(old, odd)}, dim_);
    LightChange all = partOf(changeBetween(meanOf(was.even, was.odd), meanOf(is.even, is.odd), dim_), part);
    all.gain = withGain(gain, all.gain);
    // One sample of each pixel tells how light changes, but light of its own is noise
    if (mark > 1) {
        const HalfImages fresh = smoothed(samples, mark);
        const SmoothHalves laid{laidOn(old, partOf(even, part)), laidOn(old, partOf(odd, part))};
        const Plane share =
            shareOfSecond(laid, {fresh.even, fresh.odd}, samples.even, samples.odd, dim_, pixelsAlike(mark));
        all = mixed(share, all, meanOf(fresh.even, fresh.odd));
    }
    return laidOn(old_->all, all);
}

}  // namespace pdr
