#pragma once
/// The map of the film in hand. It is made anew where it would say something else: so seldom that it costs nothing.

#include <memory>

#include "render/film/level_error_map.h"

namespace pdr {

class ErrorMapView {
  public:
    /// Another film, or none is wanted any more.
    void clear() { *this = {}; }
    /// Whether the map is to be made for a film, the part of which that is being sampled has so many samples, on a
    /// display of that exposure: when they are `growth` times as many, and enough to know errors; where that is another
    /// part, and on another display.
    bool isDue(std::uint64_t samples, float exposure, double growth) const {
        const bool better = samples >= kSamplesToEstimate && double(samples) >= growth * double(samples_);
        return !map_ || exposure != exposure_ || better || samples < samples_;
    }
    /// As isDue() was asked. Nothing changes after a stop request.
    void make(const Film& film, std::uint64_t samples, float exposure, const std::stop_token& stop) {
        auto map = std::make_shared<const LevelErrorMap>(levelErrorMap(film, double(exposure), stop));
        if (stop.stop_requested())
            return;
        map_ = std::move(map);
        samples_ = samples;
        exposure_ = exposure;
    }

    /// Null: there is none.
    const std::shared_ptr<const LevelErrorMap>& map() const { return map_; }

  private:
    std::shared_ptr<const LevelErrorMap> map_;
    std::uint64_t samples_ = 0;
    float exposure_ = 0;
};

}  // namespace pdr
