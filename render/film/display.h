#pragma once
/// How linear radiance becomes what a screen shows. Changing it never restarts a rendering.

namespace pdr {

struct Display {
    float exposure = 1;     ///< radiance that is shown as 1 - 1/e; (0, 1e30]
    bool smoothed = false;  ///< denoise/smoothing.h: the noise is taken away, and fine detail with it
    bool surveyed = true;   ///< with all of its status; else with its counts alone, where that is less work
    bool operator==(const Display&) const = default;
};

}  // namespace pdr
