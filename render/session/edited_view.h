#pragma once
/// The image before an edit, and the image of the edited scene that it helps to make (edit/edited_image.h), until the
/// new film is good enough alone. The film itself never knows of it.
///   old image    that of the last scene of this view whose film was judged at rest; during a drag, that before it
///   samples      those of each pixel of the current film
///   coarse film  one of fewer pixels, when those of the view are too many to be sampled in time

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "render/edit/coarse_edit.h"
#include "render/edit/edited_image.h"
#include "render/scene/scene.h"
#include "render/session/shown_radiance.h"

namespace pdr {

class EditedView {
  public:
    /// Ratio of a guide's pixels to those of a coarse film, along each side. The full film's guide is no finer than it:
    /// that costs more time than the samples that are as good.
    static constexpr int kCoarseFiner = 2;

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

    /// What the edit after a film needs of it, kept while another film is rendered.
    struct ForNext {
        FirstSamples first;
        std::shared_ptr<const KeptImage> image;  ///< null: none yet
        bool helped = false;                     ///< the film's last image was made with an old one
        /// Returns the memory that it takes.
        std::size_t bytes() const;
    };
    ForNext putAway() const { return {first_, newest_, hasOld()}; }
    /// Continues the film that has come back, whose own image is the best for it if it was judged.
    void comeBack(const ForNext& kept);

    /// Returns whether there is an old image.
    bool hasOld() const { return edited_.has_value(); }
    /// Returns the scene of the old image, which there must be.
    const Scene& oldScene() const { return *oldScene_; }
    /// Returns whether images of the current film, of the view's size, are made with the old one.
    bool helps(std::uint64_t samples) const { return edited_ && edited_->lastMark(first_, samples) > 0; }
    /// Returns the same of a coarse film of `size` pixels.
    bool helpsCoarse(ivec2 size, std::uint64_t samples) const;
    /// Drops the old image if the film is good enough alone; returns whether it has done so just now.
    bool letGo(std::uint64_t samples);

    // Coarse films of the old scene, made with the random numbers of the new one:
    bool hasCoarse(ivec2 size) const { return coarseOf(size) != nullptr; }
    /// Returns the nearest to `divider`, within half of it, of the dividers of a film of `size` pixels
    /// (resolution_ladder.h) whose coarse film there is; else `divider`.
    int nearestCoarse(ivec2 size, int divider) const;
    /// Keeps the first samples of such a film of `size` pixels. There must be an old image.
    void keepCoarse(ivec2 size, FirstSamples before) {
        coarse_.emplace_back(edited_->shareOld(), size, std::move(before));
    }

    // Coarse films of the current scene, for the edit to come:
    /// Returns whether there is none within a quarter of that divider of a film of `size` pixels yet, and its image has
    /// been judged with enough samples.
    bool awaitsNext(ivec2 size, int divider) const;
    void keepNext(ivec2 size, FirstSamples first) { next_.push_back({size, std::move(first)}); }

    /// Asks the device for a guide of the current film's scene, of its size, unless there is one.
    void findGuide(FilmOnDevice& place, const std::stop_token& stop);
    /// Keeps the image after the current film's first samples, if it has as many as a mark says.
    void keepFirst(FilmOnDevice& place, const SampleCounts& samples);
    /// Returns what makes the smooth halves of the current film for its judgement, where the old image does not help
    /// as `alone` does. It keeps the image for the next edit.
    HalfSmoother smoother(std::uint64_t samples, HalfSmoother alone = denoisedHalves);
    /// Returns the current film's image, made with the old one. `adds`: the film has samples that the last image did
    /// not show. Errors: the device's. Worthless after a stop request.
    Result<DisplayedImage> image(FilmOnDevice& place, const Display& display, bool adds, const std::stop_token& stop);
    /// Returns the image of the view's size from the current film, a coarse one of `size` pixels that the old image
    /// helps; radiance.
    denoise::Colours coarseRadiance(ivec2 size, std::uint64_t samples) const;

  private:
    struct Coarse {
        ivec2 size;
        FirstSamples first;
    };

    bool replacesOld() const;
    void dropOld();
    const CoarseEdit* coarseOf(ivec2 size) const;

    std::shared_ptr<const KeptImage> newest_;  ///< image of the current scene; null: none yet
    std::optional<EditedImage> edited_;        ///< with the old image
    std::optional<Scene> oldScene_;            ///< scene of the old image
    std::vector<CoarseEdit> coarse_;           ///< with the old image and scene, each of another size
    FirstSamples first_;                       ///< first samples of the current film
    std::vector<Coarse> next_;                 ///< coarse films of the current scene, each of another size
    ShownRadiance shown_;
};

}  // namespace pdr
