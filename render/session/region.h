#pragma once
/// A part of the image that gets its samples first, and the status of that part.

#include <optional>
#include <vector>

#include "render/accuracy/shown_history.h"
#include "render/accuracy/stop_rule.h"
#include "render/film/display/denoised_view.h"
#include "render/film/film.h"

namespace pdr {

/// Corners of a region, in fractions of the image's width and height from its upper left corner; 0 <= from < to <= 1.
struct Region {
    dvec2 from{0.0}, to{1.0};
    bool operator==(const Region&) const = default;
};

/// Returns the pixels of a film of `size` that the region touches, at least one.
Tile tileOf(const Region& region, ivec2 size);

/// Status of a region, from its pixels alone.
struct RegionStatus {
    Region region;
    FilmStatus status;               ///< status of the shown image in the region
    ErrorOf of = ErrorOf::film;      ///< image that its displayError speaks of
    bool reached = false;            ///< the region is within the target: the rest of the image gets the samples
    std::vector<QualityStep> steps;  ///< forecast while the region gets all samples; see ErrorHistory::steps()
    std::vector<ErrorPoint> history;
};

/// Keeps the region's status while an image is rendered. The status is updated only when it would change visibly: so
/// seldom that it costs nothing.
class RegionView {
  public:
    /// Forgets the status, for another film; the region stays.
    void clear();
    /// Sets the region; none: no part of the image takes precedence.
    void choose(const std::optional<Region>& region);
    const std::optional<Region>& region() const { return region_; }
    /// Returns the region's pixels in a film of `size`; none without a region.
    std::optional<Tile> tile(ivec2 size) const;

    /// Returns whether the status is to be updated when each pixel has so many `samples`, on a display of that
    /// tone: after each eighth more samples, and at another tone.
    bool isDue(std::uint64_t samples, const Tone& tone) const;
    /// Updates the status after `seconds` of rendering. `denoised`: what is known of the denoised image if that is
    /// shown; else null.
    void look(const Film& film, const Tone& tone, double seconds, DenoisedView* denoised = nullptr);

    /// Returns the display levels within which 95 % of the region's tissue is shown; 0 if it has no tissue, or has seen
    /// no light for long; infinite if not known yet.
    double error() const;
    /// Returns the status if rendering is to end within `target` levels; none without a region or while nothing is
    /// known.
    std::optional<RegionStatus> status(double target) const;
    /// Returns whether the region is to get all the samples.
    bool isFirst(double target) const {
        return region_ && (error() > target || (error() > 0 && status_->samplesPerPixel < kSamplesToStop));
    }

  private:
    std::optional<Region> region_;
    std::optional<FilmStatus> status_;
    ErrorOf of_ = ErrorOf::film;  ///< image that its displayError speaks of
    Tone tone_{0};                ///< tone that status_ refers to
    ShownHistory history_;
};

}  // namespace pdr
