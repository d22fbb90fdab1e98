#pragma once
/// Assembles the provenance of an image from its scene and from how it was rendered.

#include <string>

#include "render/accuracy/bias.h"
#include "render/film/display.h"
#include "render/film/file/provenance.h"
#include "render/scene/schedule.h"
#include "render/tiles/node_checks.h"

namespace pdr {
struct Scene;
}

namespace pdr::app {

/// Returns the name of a schedule used for comparison: "Exposure Render's K1, blurred". Empty for this program's own
/// schedule.
std::string scheduleText(const Schedule& schedule);

/// Facts about an image that its scene does not contain.
struct Rendered {
    FilmStatus status;  ///< status on a display of `tone`
    Tone tone;
    double seconds = 0;
    std::string device;      ///< name of the device: "cpu"
    MeasuredBiases bias;     ///< biases that are known only by measuring
    NodeChecks checks = {};  ///< what was checked of the samples of render nodes
};

/// Returns the facts about bias of an image that is not denoised.
BiasFacts biasFactsOf(const Scene& scene, const Rendered& rendered);

Provenance provenanceOf(const Scene& scene, const Rendered& rendered);

}  // namespace pdr::app
