#pragma once
/// How coarse the first picture of an edit must be to come in time, and the steps from there to the full film.
///   divider   so many pixels of the full film become one, along each side; 1: the film itself
///   samples   of pixels, all together
/// A picture gives way to a finer one only when that has as many samples in each of its pixels: then the finer one is
/// nowhere noisier, nor darker, as a picture of too few samples is behind a bent tone curve.

#include <cstdint>

#include "render/base/portable.h"
#include "render/timing/recent.h"

namespace pdr {

class ResolutionLadder {
  public:
    /// From the edit to the end of its picture's making; as much again may pass until it is on the screen.
    static constexpr double kFrameSeconds = 0.05;
    /// Of each pixel of a first picture: fewer, calmer pixels are easier to follow.
    static constexpr std::uint32_t kSamples = 4;
    static constexpr int kCoarsest = 24;
    /// A coarse film's picture is drawn on a guide so many times as fine (denoise/guided.h), where the device has one:
    /// finer than the full film it need not be.
    static constexpr int kGuide = 4;
    static constexpr int finer(int divider) { return divider < kGuide ? divider : kGuide; }

    /// A scene took `seconds` before its first sample.
    void addBeginning(double seconds) { beginning_.add(seconds); }
    /// That many samples took `seconds`, and their display where that cannot be told apart. 0 seconds say nothing.
    void addFrame(double samples, double seconds);
    /// To show that many pixels took `seconds`, smoothing included.
    void addDisplay(double pixels, double seconds) { displaySeconds_.add(seconds / pixels); }
    /// To show so many of a coarse film on a guide took `seconds`, the guide included.
    void addGuidedDisplay(double pixels, double seconds) { guidedSeconds_.add(seconds / pixels); }

    /// Samples a second, lately; a guess before the first frame.
    double speed() const;
    /// What is left of a frame's time for its samples, in a coarse film of that many pixels.
    double secondsForSamples(double pixels) const;
    /// The first divider for a full film of `size` pixels.
    int first(ivec2 size) const;
    /// The next finer one: half as coarse. Together such steps cost a third of the full film's first picture.
    static int next(int divider) { return divider > 1 ? divider / 2 : 1; }

  private:
    static constexpr std::size_t kRecent = 5;
    double secondsForPixels() const;
    double secondsToShowCoarse() const;

    Recent beginning_{kRecent}, speed_{kRecent};
    Recent displaySeconds_{kRecent}, guidedSeconds_{kRecent};  ///< of a film's pixel
};

/// The film of that divider: at least 1 x 1, and no larger than so many parts of the full one.
ivec2 dividedFilm(ivec2 size, int divider);

}  // namespace pdr
