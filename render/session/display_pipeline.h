#pragma once
/// The images of the current film on their way to the screen, and the coarser film that is shown until the first of
/// them comes.

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "render/base/result.h"
#include "render/film/display/enlarged_film.h"
#include "render/session/film_on_device.h"

namespace pdr {

struct DisplayedImage {
    Image image;
    Display display;  ///< requested display that the image was made for
    ivec2 size;       ///< pixels
};

class DisplayPipeline {
  public:
    using Images = std::vector<DisplayedImage>;

    /// Starts with another film, whose images so far are lost. `isEmpty`: the film has no samples, so that its first
    /// image is still to come.
    void reset(bool isEmpty);

    /// Returns whether the film's first image is still to come.
    bool awaitsFirst() const { return first_; }
    /// Returns whether the film's first image from this device is still to come, or a new judgement is to be shown.
    bool isFresh() const { return fresh_; }
    /// Returns whether the first image was interrupted: it is to be made before more samples.
    bool isBroken() const { return broken_; }
    /// Returns whether images were requested and not yet read back.
    bool hasWaiting() const { return !waiting_.empty(); }
    /// Records that a new judgement of the image is to be shown.
    void refresh() { fresh_ = true; }
    /// Records that the making of an image was interrupted.
    void breakOff() { broken_ = first_; }
    /// Records that an image of the film was made. The coarser film is not needed any more.
    void markShown();
    /// Records that the film has come back with its samples: its image is to be made before more of them.
    void markReturned();
    /// Records that an image of the film that was made before has been shown again.
    void markShownBefore() { broken_ = false; }

    // Images of the film. Errors: the device's.
    /// Finds the guide to draw a coarse film on, with `finer` pixels along each of the film's; returns whether there is
    /// one. The device makes it once for all images. It is requested again only if making it was interrupted.
    bool findGuide(FilmOnDevice& place, int finer, const std::stop_token& stop);
    bool hasGuide() const { return guide_ != nullptr; }
    /// Draws the film on its guide and returns that image; a coarse film has no images in flight. `adds`: the film
    /// holds more samples than when it was last drawn.
    Result<Images> makeOnGuide(FilmOnDevice& place, const Display& asked, bool adds);
    /// Returns the coarse film's image in more pixels, as makeOnGuide() does; `radiance` computes it.
    Result<Images> makeLarger(FilmOnDevice& place, const Display& asked, bool adds,
                              const std::function<denoise::Colours()>& radiance);
    /// Requests an image with `display`, in answer to `asked`, and returns the images that are due: all, or, if not
    /// `atOnce`, all except those that may stay in flight. A denoised image that was interrupted is not among them.
    Result<Images> make(FilmOnDevice& place, const Display& asked, const Display& display, bool atOnce,
                        const std::stop_token& stop);
    /// Reads back the images that were requested, oldest first, except for the last `left`.
    Result<Images> takeAllBut(FilmOnDevice& place, std::size_t left);

    // The coarser film of the same scene.
    /// Shows `film`, the current film, until the next one has an image that is no worse.
    void keepCoarser(std::shared_ptr<const Film> film);
    void dropCoarser() { coarser_.reset(); }
    bool hasCoarser() const { return coarser_.has_value(); }
    /// Returns its samples per pixel; nothing without a coarser film.
    std::optional<std::uint64_t> coarserSamples() const;
    /// Returns its image with `display`, in answer to `asked`; nothing after a stop request. There must be a coarser
    /// film.
    std::optional<DisplayedImage> coarserImage(const Display& asked, const Display& display,
                                               const std::stop_token& stop);

  private:
    using Enlarge = std::function<EnlargedFilm(std::shared_ptr<const Film>)>;
    Result<Images> enlarge(FilmOnDevice& place, const Display& asked, bool adds, const Enlarge& enlarge);

    struct Coarser {
        std::shared_ptr<const Film> film;
        std::shared_ptr<const EnlargedFilm> larger;  ///< the film in more pixels; null: it was not shown so
        Development images;
    };

    bool first_ = false, fresh_ = false, broken_ = false;  ///< see awaitsFirst(), isFresh() and isBroken()
    std::deque<Display> waiting_;                          ///< displays of the images in flight, oldest first
    std::shared_ptr<const denoise::Guide> guide_;          ///< null: none, or not yet
    bool guideSought_ = false;                             ///< the guide has been requested from the device
    std::shared_ptr<const EnlargedFilm> larger_;  ///< the film in more pixels, as last shown; null if not shown so
    std::optional<Coarser> coarser_;
};

}  // namespace pdr
