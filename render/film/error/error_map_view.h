#pragma once
/// The map of the film in hand. It is made anew where it would say something else: so seldom that it costs nothing.

#include <memory>
#include <utility>

#include "render/film/error/level_error_map.h"
#include "render/film/error/shown_status.h"

namespace pdr {

class ErrorMapView {
  public:
    /// Another film, or none is wanted any more.
    void clear() { *this = {}; }
    /// Whether the map is to be made of an image of a film, the part of which that is being sampled has so many
    /// samples, on a display of that exposure: when they are `growth` times as many, and enough to know errors; where
    /// that is another image or part, and on another display.
    bool isDue(ErrorOf of, std::uint64_t samples, float exposure, double growth) const {
        const bool better = samples >= kSamplesToEstimate && double(samples) >= growth * double(samples_);
        return !map_ || of != of_ || exposure != exposure_ || better || samples < samples_;
    }
    /// As isDue() was asked.
    void keep(LevelErrorMap map, ErrorOf of, std::uint64_t samples, float exposure) {
        map_ = std::make_shared<const LevelErrorMap>(std::move(map));
        of_ = of;
        samples_ = samples;
        exposure_ = exposure;
    }

    /// Null: there is none.
    const std::shared_ptr<const LevelErrorMap>& map() const { return map_; }

  private:
    std::shared_ptr<const LevelErrorMap> map_;
    ErrorOf of_ = ErrorOf::film;
    std::uint64_t samples_ = 0;
    float exposure_ = 0;
};

}  // namespace pdr
