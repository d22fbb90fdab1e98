#pragma once
/// The place in the patient that a point of the image shows, or why it shows none. A point of a translucent image is no
/// point of the patient: it shows a place only where at least half of all light stops in one layer (light_layers.h).

#include <vector>

#include "render/prepare/prepared_scene.h"

namespace pdr {

/// A layer that is seen under a point of the image.
struct SeenLayer {
    dvec3 placeMm;         ///< median of the light that stops in the layer, in the patient (LPS)
    double depthMm;        ///< distance of the place from the eye along the view
    double share;          ///< share of all light under the point; (0, 1]
    double sigmaAlongMm;   ///< standard deviation of the place along the ray
    double sigmaAcrossMm;  ///< standard deviation across the ray: the pixel, and the lens where it is out of focus
    bool onSilhouette;     ///< the depth jumps by more than 5 mm within 1.5 mm, and sigmaAlongMm holds these jumps
};

/// What the light under a point of the image says about its place.
enum class SeenAt {
    place,      ///< at least half of all light stops in one layer
    choice,     ///< no layer holds half of the light, but at least one a share of 15 %
    fog,        ///< no layer holds 15 %
    nothing,    ///< less than 15 % of the light meets tissue, or the point lies outside the image
    everyDepth  ///< the model adds up all depths without one hiding another: absorption and emission
};

struct LayersUnder {
    SeenAt seen = SeenAt::nothing;
    std::vector<SeenLayer>
        layers;           ///< one for a place, those that can be chosen for a choice, nearest first; else none
    double met = 0;       ///< share of all light that meets tissue; [0, 1]
    double spreadMm = 0;  ///< fog: length of the ray that holds the middle 80 % of the light that meets tissue
    dvec3 direction{0};   ///< direction of the ray: unit, away from the viewer, in the patient's axes

    /// Returns the layer with the greatest share; null if there is none.
    const SeenLayer* heaviest() const;
};

/// Returns what is seen at `place`, in pixels from the image's upper left corner; the middle of pixel (x, y) is at
/// (x + 0.5, y + 0.5). `scene` must come from Flattener::prepare(). A layer is listed only if at least 15 % of all
/// light stops within 1 mm of its place. For maximumIntensity the only layer is the highest HU on the ray, if it is not
/// black, with the distance between voxels along the ray as the width of its uniform error.
LayersUnder layersUnder(const PreparedScene& scene, vec2 place);

}  // namespace pdr
