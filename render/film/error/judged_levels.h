#pragma once
/// What the errors of a denoised image are in display levels, from their variances (error_classes.h): the errors
/// of a pixel are taken as normal, and each of a few quantiles of theirs goes through the tone curve. The tone curve's
/// slope would not do: it is steep in the dark, and errors there are as large as the light.

#include "render/film/error/channel_margin.h"

namespace pdr {

/// Sums over the pixels of a region, tile by tile.
class JudgedLevels {
  public:
    /// `tone`: of the display.
    explicit JudgedLevels(const Tone& tone) : transform_(displayTransform(tone)), perExposure_(1 / tone.exposure) {}

    /// Adds a pixel of the current tile. `squaredErrors`: unbiased estimates, of which `variance` is the mean over
    /// similar pixels, and `correlation` that of the channels' errors in them (ErrorClasses). In the unit of the
    /// exposure.
    void add(ivec2 pixel, vec3 light, vec3 variance, vec3 squaredErrors, float correlation);
    /// Ends a tile, whose errors count as one draw; one without pixels is none.
    void endTile();
    /// Adds the tiles of `other`.
    void add(const JudgedLevels& other);

    /// Returns the levels that 95 % of the pixels are not off in any channel.
    double levels() const { return errorQuantile(counts_, 0.95); }
    /// Returns the standard deviation of the mean squared error in levels of the worst channel, in parts of that mean,
    /// from how far the tiles are from what the variances say of them; 0 where nothing is off. `fitted`: parameters of
    /// the variances that were fitted to the same tiles, which must be more.
    double uncertainty(int fitted) const;

  private:
    DisplayTransform transform_;
    float perExposure_;
    ErrorCounts counts_;
    double tiles_ = 0;
    bool isInTile_ = false;  ///< the current tile has pixels
    dvec3 tile_{0.0};        ///< sums over the current tile of squared errors less variances [levels²]
    dvec3 variances_{0.0};   ///< sums of variances [levels²]
    dvec3 squares_{0.0};     ///< sums of the squares of all tiles' sums
};

}  // namespace pdr
