#pragma once
/// How far a pixel's levels are off when only the sizes of its channels' errors are known, and how they go together.
/// With the tone curve keepsHue a level depends on two channels, its own and the largest. Let e be what it is off by if
/// the errors come together, and e_k if that of channel k comes alone. Errors of the correlation r then make, to first
/// order, the variance r e^2 + (1 - r) (e_1^2 + e_2^2 + e_3^2), which is exact for any r >= 0 that is the same for all
/// pairs. Errors under white light have an r near 1; taken as independent they would be stated up to 1.6 times too
/// large in bright greys.

#include "render/film/display_error.h"

namespace pdr {

/// Returns how many levels the worst channel of a pixel is off if its channels are off by `off`, whose signs are those
/// of the errors that come together. `mean` and `off` are in units of the exposure.
inline float levelsApart(const DisplayTransform& transform, vec3 mean, vec3 off, float correlation) {
    const vec3 joint = channelsOff(transform, mean, off);
    if (transform.curve == ToneCurve::perChannel || correlation >= 1)
        return glm::max(joint.x, glm::max(joint.y, joint.z));
    vec3 squares(0.0f);
    for (int k = 0; k < 3; ++k) {
        vec3 alone(0.0f);
        alone[k] = off[k];
        const vec3 levels = channelsOff(transform, mean, alone);
        squares += levels * levels;
    }
    squares = glm::mix(squares, joint * joint, correlation);
    return std::sqrt(glm::max(squares.x, glm::max(squares.y, squares.z)));
}

}  // namespace pdr
