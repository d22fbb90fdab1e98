#pragma once
/// The error map of the current film. It is computed again only where it would differ visibly, so seldom that it costs
/// almost nothing.

#include <memory>
#include <utility>

#include "render/film/error/level_error_map.h"
#include "render/film/error/shown_status.h"

namespace pdr {

class ErrorMapView {
  public:
    /// Drops the map, for another film or where no map is requested any more.
    void clear() { *this = {}; }
    /// Returns whether to compute the map of the image `of` of a film whose currently sampled part has so many samples
    /// per pixel, on a display of that tone: true once there are `growth` times as many as for the last map, and
    /// enough to know errors; without a map; for another image, display or part.
    bool isDue(ErrorOf of, std::uint64_t samples, const Tone& tone, double growth) const {
        const bool better = samples >= kSamplesToEstimate && double(samples) >= growth * double(samples_);
        return !map_ || of != of_ || tone != tone_ || better || samples < samples_;
    }
    /// Stores a map; the other arguments are those of isDue().
    void keep(LevelErrorMap map, ErrorOf of, std::uint64_t samples, const Tone& tone) {
        map_ = std::make_shared<const LevelErrorMap>(std::move(map));
        of_ = of;
        samples_ = samples;
        tone_ = tone;
    }

    /// Returns the map; null if there is none.
    const std::shared_ptr<const LevelErrorMap>& map() const { return map_; }

  private:
    std::shared_ptr<const LevelErrorMap> map_;
    ErrorOf of_ = ErrorOf::film;
    std::uint64_t samples_ = 0;
    Tone tone_;
};

}  // namespace pdr
