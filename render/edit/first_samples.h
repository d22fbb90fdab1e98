#pragma once
/// The image after its first samples, kept while more are taken: an image of another look that is made with the same
/// random numbers differs from it by what the edit changed, and by little noise. With it the light that needs no
/// samples, which tells most of what an edit of tissue changes before the first of them.
///   half   two images of independent samples: of those with even and with odd numbers, or of one sample per pixel the
///          two colours of a chessboard
///   unshadowed  the light of a guide (denoise/guided.h), without shadows and noise

#include <array>
#include <cstdint>
#include <memory>

#include "render/denoise/guided.h"
#include "render/film/film.h"

namespace pdr {

/// Two images of the same scene from independent samples; radiance.
struct HalfImages {
    denoise::Colours even, odd;
};

/// Returns the halves of `film`, in which every pixel has the same samples, at least one. Of one sample per pixel, a
/// half takes every other pixel, and in between the mean of the four around it.
HalfImages halfImagesOf(const Film& film);

/// Returns the halves of an image of `mark` samples without most of their noise: each is smoothed by a box, twice,
/// which is nearly a Gaussian, the narrower the more samples there are.
HalfImages smoothed(const HalfImages& halves, std::uint64_t mark);

/// Returns the same smoothed as far as a change of light can be, which is smooth where the image is not.
HalfImages smoothedForChange(const HalfImages& halves, std::uint64_t mark);

/// Returns the pixels of a half of `mark` samples that share their noise; 1: each has its own.
float pixelsAlike(std::uint64_t mark);

/// Returns the mean of two images.
denoise::Colours meanOf(const denoise::Colours& a, const denoise::Colours& b);

class FirstSamples {
  public:
    /// The numbers of samples after which the image is kept.
    static constexpr std::array<std::uint64_t, 4> kMarks{1, 4, 16, 64};
    static bool isMark(std::uint64_t samples);
    /// Returns how many samples are left from `samples` to the next mark; a large number behind the last one.
    static std::uint64_t leftToMark(std::uint64_t samples);

    /// Forgets all, for another film.
    void clear() { *this = {}; }
    /// Keeps the image of `film` if all its pixels have a mark's number of samples.
    void keep(const Film& film);
    /// Keeps the light of a guide of the film's scene.
    void keepUnshadowed(const denoise::Guide& guide);
    /// Returns that light in the film's size, with smooth edges, in the guide's unit; null if it was not kept.
    std::shared_ptr<const denoise::Colours> unshadowed() const { return unshadowed_; }
    /// Returns the image after `mark` samples; null if it was not kept.
    std::shared_ptr<const HalfImages> at(std::uint64_t mark) const;
    /// Returns the memory that the images take.
    std::size_t bytes() const;
    /// Returns the last mark, at most `samples`, that this and `other` have kept; 0 without any.
    std::uint64_t lastShared(const FirstSamples& other, std::uint64_t samples) const;

  private:
    std::array<std::shared_ptr<const HalfImages>, kMarks.size()> kept_;
    std::shared_ptr<const denoise::Colours> unshadowed_;
};

}  // namespace pdr
