#pragma once
/// The image of an edited scene at full size from films of fewer pixels, while there is no time for more: the change
/// between a coarse film of the scene before and one of the scene now, both made with the same random numbers, is laid
/// on the sharp image before the edit (light_change.h). Where that fails, the new coarse film is shown, smoothed and
/// enlarged, in the proportion that the halves of its samples tell (mixture.h).

#include <cstdint>
#include <memory>

#include "render/edit/kept_image.h"

namespace pdr {

class CoarseEdit {
  public:
    /// `old`: image of the scene before. `before`: first samples of its coarse film, of `size` pixels.
    CoarseEdit(std::shared_ptr<const KeptImage> old, ivec2 size, FirstSamples before);

    /// Returns the number of pixels of the coarse films.
    ivec2 size() const { return reduced_[0].size(); }
    /// Returns the last mark that both coarse films have reached when the new one has `samples`; 0: none.
    std::uint64_t lastMark(const FirstSamples& after, std::uint64_t samples) const {
        return before_.lastShared(after, samples);
    }
    /// Returns the image at full size from the first `mark` samples of the new coarse film; radiance.
    denoise::Colours radiance(const FirstSamples& after, std::uint64_t mark) const;

  private:
    std::shared_ptr<const KeptImage> old_;
    denoise::Colours reduced_;  ///< the old image in the size of the coarse films
    FirstSamples before_;
    float dim_;
};

}  // namespace pdr
