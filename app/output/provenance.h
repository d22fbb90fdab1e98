#pragma once
/// How a picture came about, from what is known of it.

#include <string>

#include "render/accuracy/bias.h"
#include "render/film/file/provenance.h"
#include "render/scene/schedule.h"

namespace pdr {
struct Scene;
}

namespace pdr::app {

/// A schedule that is for comparison: "Exposure Render's K1, blurred". Empty: ours.
std::string scheduleText(const Schedule& schedule);

/// What a scene does not say of its picture.
struct Rendered {
    FilmStatus status;  ///< on a display of `exposure`
    float exposure = 1;
    double seconds = 0;
    std::string device;   ///< its name: "cpu"
    MeasuredBiases bias;  ///< of ways that only measuring tells it of
};

/// Of a picture that is not smoothed.
BiasFacts biasFactsOf(const Scene& scene, const Rendered& rendered);

Provenance provenanceOf(const Scene& scene, const Rendered& rendered);

}  // namespace pdr::app
