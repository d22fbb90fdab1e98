#pragma once
/// The whole way from the radiance of a pixel to its display levels (tone_curve.h). The same bits on every device.

#include <cstdint>

#include "render/film/display.h"
#include "render/film/levels.h"
#include "render/film/tone_curve.h"

namespace pdr {

struct DisplayTransform {
    const double* thresholds;  ///< displayThresholds()
    const float* greys;        ///< displayCurve()
    const vec2* hues;          ///< hueCurve()
    const float* lights;       ///< lightCurve()
    double exposure;
    ToneCurve curve;

    /// Returns the levels before they are rounded, [0, 255], off by less than 0.01; `light` is in units of the
    /// exposure, and what is not above 0 counts as 0. No channel exceeds the largest one.
    PDR_HD vec3 exactLevels(vec3 light) const {
        if (curve == ToneCurve::perChannel)
            return {exactLevelOf(greys, light.x), exactLevelOf(greys, light.y), exactLevelOf(greys, light.z)};
        const float x = light.x > 0 ? light.x : 0, y = light.y > 0 ? light.y : 0, z = light.z > 0 ? light.z : 0;
        const float largest = glm::max(x, glm::max(y, z));
        if (!(largest > 0))
            return vec3(0);
        const vec2 hue = hueAt(hues, largest);
        const float most = exactLevelOf(greys, largest);
        return {hueLevel(x, largest, most, hue), hueLevel(y, largest, most, hue), hueLevel(z, largest, most, hue)};
    }
    PDR_HD vec3 exactLevels(dvec3 radiance) const { return exactLevels(vec3(radiance / exposure)); }

    /// Sets the levels of a pixel. Those of greys are rounded exactly by both curves; those of other channels than the
    /// largest that keepsHue shows may be rounded the other way within 0.01 of the middle between two levels.
    PDR_HD void setLevels(dvec3 radiance, std::uint8_t* rgb) const {
        const dvec3 light = radiance / exposure;
        if (curve == ToneCurve::perChannel) {
            for (int c = 0; c < 3; ++c)
                rgb[c] = levelNear(thresholds, greys, light[c]);
            return;
        }
        const double largest = glm::max(light.x, glm::max(light.y, light.z));
        const std::uint8_t most = levelNear(thresholds, greys, largest);
        const vec2 hue = hueAt(hues, float(largest));
        for (int c = 0; c < 3; ++c) {
            const float exact = exactLevelOfLight(lights, hue.x * (light[c] > 0 ? float(light[c]) : 0) + hue.y);
            // NOLINTNEXTLINE(bugprone-incorrect-roundings): never below 0
            rgb[c] = light[c] == largest ? most : glm::min(most, std::uint8_t(exact + 0.5f));
        }
    }

  private:
    /// Returns the level of the channel `light`, at least 0, of a pixel whose largest channel has the level `most`.
    PDR_HD float hueLevel(float light, float largest, float most, vec2 hue) const {
        return light == largest ? most : glm::min(most, exactLevelOfLight(lights, hue.x * light + hue.y));
    }
};

/// Returns the transform for the host.
inline DisplayTransform displayTransform(const Tone& tone) {
    return {displayThresholds().data(), displayCurve(), hueCurve(), lightCurve(), double(tone.exposure), tone.curve};
}

}  // namespace pdr
