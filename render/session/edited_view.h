#pragma once
/// The image before an edit, and the image of the edited scene that it helps to make (edit/edited_image.h), until the
/// new film is good enough alone. The film itself never knows of it.
///   old image    that of the last scene of this view whose film was judged at rest; during a drag, that before it
///   samples      those of each pixel of the current film

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>

#include "render/edit/edited_image.h"
#include "render/session/display_pipeline.h"

namespace pdr {

struct Scene;

class EditedView {
  public:
    /// Returns whether images of the scene are kept: those of many pixels take too much memory, and projections and
    /// images of Exposure Render's schedule are not denoised.
    static bool canKeep(const Scene& scene);
    /// Replaces the current scene by `next`. The old image stays or is replaced by that of the current scene, unless
    /// `next` shows another view.
    void follow(const Scene& current, const Scene& next);
    /// Forgets all images.
    void forget() { *this = {}; }
    /// Forgets what is known of the current film, which begins anew.
    void startOver();

    /// Returns whether there is an old image.
    bool hasOld() const { return edited_.has_value(); }
    /// Returns whether images of the current film are made with the old one.
    bool helps(std::uint64_t samples) const { return edited_ && edited_->lastMark(first_, samples) > 0; }
    /// Drops the old image if the film is good enough alone; returns whether it has done so just now.
    bool letGo(std::uint64_t samples);

    /// Keeps the image after the current film's first samples, if it has as many as a mark says.
    void keepFirst(FilmOnDevice& place, const SampleCounts& samples);
    /// Returns what makes the smooth halves of the current film for its judgement. It keeps the image for the next
    /// edit.
    HalfSmoother smoother(std::uint64_t samples);
    /// Returns the current film's image, made with the old one. `adds`: the film has samples that the last image did
    /// not show. Errors: the device's. Worthless after a stop request.
    Result<DisplayedImage> image(FilmOnDevice& place, const Display& display, bool adds, const std::stop_token& stop);

  private:
    std::shared_ptr<const KeptImage> newest_;        ///< image of the current scene; null: none yet
    std::optional<EditedImage> edited_;              ///< with the old image
    FirstSamples first_;                             ///< first samples of the current film
    std::shared_ptr<const denoise::Colours> shown_;  ///< radiance of the image shown last; null: none
};

}  // namespace pdr
