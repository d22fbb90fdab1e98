#pragma once
/// A part of the picture that gets its samples first, and how good that part is.

#include <optional>
#include <vector>

#include "render/accuracy/shown_history.h"
#include "render/accuracy/stop_rule.h"
#include "render/film/display/smoothed_view.h"
#include "render/film/film.h"

namespace pdr {

/// Corners, in fractions of the picture's width and height from its upper left corner; 0 <= from < to <= 1.
struct Region {
    dvec2 from{0.0}, to{1.0};
    bool operator==(const Region&) const = default;
};

/// The pixels of a film of `size` that the region touches, at least one.
Tile tileOf(const Region& region, ivec2 size);

/// Of its pixels alone.
struct RegionStatus {
    Region region;
    FilmStatus status;               ///< of what is shown of them
    ErrorOf of = ErrorOf::film;      ///< image that its displayError speaks of
    bool reached = false;            ///< it is within the target: the rest of the picture gets the samples
    std::vector<QualityStep> steps;  ///< while it gets all the samples; see ErrorHistory::steps()
    std::vector<ErrorPoint> history;
};

/// The region's status while a picture is made. It is found out anew where it would say something else: so seldom that
/// it costs nothing.
class RegionView {
  public:
    /// Another film; the region stays.
    void clear();
    /// None: the picture is one whole.
    void choose(const std::optional<Region>& region);
    const std::optional<Region>& region() const { return region_; }
    /// Of a film of `size`; none without a region.
    std::optional<Tile> tile(ivec2 size) const;

    /// Whether the status is to be found out where each pixel has so many `samples`, on a display of that exposure: at
    /// each eighth more, and on another display.
    bool isDue(std::uint64_t samples, float exposure) const;
    /// After `seconds` of rendering. `denoised`: what is known of the denoised image where that is shown; null: it is
    /// not.
    void look(const Film& film, float exposure, double seconds, SmoothedView* denoised = nullptr);

    /// Display levels within which 95 % of its tissue is shown; 0 where there is none, or no light for long. Infinite:
    /// not known yet.
    double error() const;
    /// Where rendering is to end within `target` levels. None without a region.
    std::optional<RegionStatus> status(double target) const;
    /// Whether it is to get all the samples.
    bool isFirst(double target) const {
        return region_ && (error() > target || (error() > 0 && status_->samplesPerPixel < kSamplesToStop));
    }

  private:
    std::optional<Region> region_;
    std::optional<FilmStatus> status_;
    ErrorOf of_ = ErrorOf::film;  ///< image that its displayError speaks of
    float exposure_ = 0;          ///< of that
    ShownHistory history_;
};

}  // namespace pdr
