#pragma once
/// Chooses how coarse the first image of an edit must be to come in time, and the steps from there to the full film.
///   divider   pixels of the full film, along each side, that become one pixel; 1: the film itself
///   samples   total over all pixels
/// An image is replaced by a finer one only when that has as many samples in each of its pixels. The finer one is then
/// nowhere noisier, nor darker, as an image of too few samples is behind a curved tone curve. An image that is made on
/// features of the scene is better with one sample.

#include <cstdint>

#include "render/base/portable.h"
#include "render/timing/recent.h"

namespace pdr {

class ResolutionLadder {
  public:
    /// Time from the edit to the end of making its image; as much again may pass until it is on the screen.
    static constexpr double kFrameSeconds = 0.05;
    /// Time from an edit to its first image where all of its pixels are sampled.
    static constexpr double kEditSeconds = 0.12;
    /// Time from an edit to the end of making its image from coarse films (edit/coarse_edit.h): a hand that moves waits
    /// for two such images at most.
    static constexpr double kCoarseEditSeconds = 0.027;
    /// Time for the first image of an edit without a drag, which is looked at.
    static constexpr double kRestingEditSeconds = 0.06;
    /// Longest time that a full image made on features may take in place of a coarse one.
    static constexpr double kFeaturedSeconds = 2;
    /// Samples per pixel of a first image: fewer pixels with less noise are easier to follow.
    static constexpr std::uint32_t kSamples = 4;
    static constexpr int kCoarsest = 24;
    /// Ratio, along each side, of a guide's pixels to those of the coarse film whose image is drawn on it
    /// (denoise/guided.h), if the device has one. A guide need not be finer than the full film.
    static constexpr int kGuide = 4;
    static constexpr int finer(int divider) { return divider < kGuide ? divider : kGuide; }

    /// Records that a scene took `seconds` before its first sample.
    void addBeginning(double seconds) { beginning_.add(seconds); }
    /// Records the same of a scene that an edit changed in the same view: that changes other things than a turn does.
    void addEditBeginning(double seconds) { editBeginning_.add(seconds); }
    /// Records that so many samples took `seconds`, including their display if that cannot be separated. 0 seconds are
    /// ignored.
    void addFrame(double samples, double seconds);
    /// Records that showing so many pixels took `seconds`, denoising included.
    void addDisplay(double pixels, double seconds) { displaySeconds_.add(seconds / pixels); }
    /// Records that showing so many pixels of a coarse film on a guide took `seconds`, the guide included.
    void addGuidedDisplay(double pixels, double seconds) { guidedSeconds_.add(seconds / pixels); }

    /// Records that the first image after an edit, of so many pixels and made with the one before, took `seconds`.
    void addEditedDisplay(double pixels, double seconds) { editedSeconds_.add(seconds / pixels); }

    /// Records that the image of a coarse film, laid on the full one before an edit, took `seconds`. Most of them are
    /// for the pixels of the full image.
    void addCoarseEditDisplay(double seconds) { coarseEditSeconds_.add(seconds); }

    /// Returns whether one sample for each of `size` pixels, and their image with the one before an edit, come in time.
    bool editIsInTime(ivec2 size) const;
    /// Returns the recent samples per second; a guess before the first frame.
    double speed() const;
    /// Returns the part of a frame's time that is left for samples in a coarse film of that many pixels [s].
    double secondsForSamples(double pixels) const;
    /// Returns the first divider for a full film of `size` pixels.
    int first(ivec2 size) const;
    /// Returns the part of an edit's time that is left for the samples of its coarse film [s]. `moving`: the user
    /// drags.
    double secondsForEdit(bool moving) const;
    /// Returns the divider of the coarse film after an edit of an image of `size` pixels, at least 2.
    int forEdit(ivec2 size, bool moving) const;
    /// Returns the next finer divider, half of this one. All such steps together cost a third of the full film's first
    /// image.
    static int next(int divider) { return divider > 1 ? divider / 2 : 1; }
    /// Returns the same where images of the full film of `size` pixels are made on features of the scene
    /// (denoise/regression.h): 1 as soon as the next step is fine enough to take a good part of the time that such an
    /// image does, and that is not long.
    int nextOnFeatures(int divider, ivec2 size) const;

  private:
    static constexpr std::size_t kRecent = 5;
    double secondsForPixels() const;
    double secondsToShowCoarse() const;
    double secondsToBeginEdit() const;

    Recent beginning_{kRecent}, editBeginning_{kRecent}, speed_{kRecent};
    Recent displaySeconds_{kRecent}, guidedSeconds_{kRecent};  ///< per pixel of a film
    Recent editedSeconds_{kRecent};                            ///< per pixel of an image made with the one before
    Recent coarseEditSeconds_{kRecent};                        ///< per image
};

/// Returns the size of the film with that divider: at least 1 x 1, and no larger than the full film over the divider.
ivec2 dividedFilm(ivec2 size, int divider);

}  // namespace pdr
