#pragma once
/// Settings that map linear radiance to what a screen shows. Changing them never restarts a rendering.

namespace pdr {

struct Display {
    float exposure = 1;     ///< radiance that is shown as 1 - 1/e; (0, 1e30]
    bool denoised = false;  ///< show the denoised image (denoise/smoothing.h), which loses fine detail with the noise
    bool surveyed = true;   ///< compute the full status; false: only its counts, where that is less work
    bool operator==(const Display&) const = default;
};

}  // namespace pdr
