#pragma once
/// Settings that map linear radiance to what a screen shows. Changing them never restarts a rendering.

#include <cstdint>

namespace pdr {

/// How the three channels of a pixel go through the tone curve (tone_curve.h).
enum class ToneCurve : std::uint8_t {
    perChannel,  ///< each alone: hues turn as they get bright, ivory over yellow to white
    keepsHue,    ///< the largest channel, the others in proportion, then towards white
};

/// Returns the name of a curve in files.
constexpr const char* toneCurveName(ToneCurve curve) {
    return curve == ToneCurve::keepsHue ? "keepsHue" : "perChannel";
}

/// What turns radiance into levels, the same for every image of a film.
struct Tone {
    float exposure = 1;  ///< radiance of a grey that is shown as 1 - 1/e; (0, 1e30]
    ToneCurve curve = ToneCurve::perChannel;

    constexpr Tone() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): an exposure alone is a tone
    constexpr Tone(double exposure, ToneCurve curve = ToneCurve::perChannel)
        : exposure(float(exposure)), curve(curve) {}
    bool operator==(const Tone&) const = default;
};

struct Display {
    float exposure = 1;     ///< as Tone::exposure
    bool denoised = false;  ///< show the denoised image (denoise/smoothing.h), which loses fine detail with the noise
    bool surveyed = true;   ///< compute the full status; false: only its counts, where that is less work
    ToneCurve curve = ToneCurve::perChannel;

    /// Returns this display with that choice of `denoised`.
    Display withDenoised(bool wanted) const {
        Display other = *this;
        other.denoised = wanted;
        return other;
    }
    // NOLINTNEXTLINE(google-explicit-constructor): a display is a tone with switches
    operator Tone() const { return {double(exposure), curve}; }
    bool operator==(const Display&) const = default;
};

}  // namespace pdr
