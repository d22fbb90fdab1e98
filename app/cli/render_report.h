#pragma once
/// What `pdrender-cli render` says on standard output when a picture is written.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "render/accuracy/bias.h"
#include "render/base/portable.h"
#include "render/device/device.h"
#include "render/prepare/warnings.h"
#include "render/session/batch_render.h"

namespace pdr::app {

struct RenderReport {
    std::vector<std::filesystem::path> outputs;
    ivec2 size{0};  ///< pixels
    std::uint64_t seed = 0;
    DeviceInfo device;
    BatchResult result;
    std::vector<Warning> warnings;  ///< of the scene
    std::vector<Bias> biases;
};

/// A JSON object: outputs, width, height, samplesPerPixel, rejectedSamples, health, seconds, samplesPerSecond (of all
/// pixels together), warnings (names: overDense), relativeError and displayError (null while unknown), tissuePixels,
/// unseenShare, biases (each with cause, ofComputing, text; brightness and levels with value, low, high;
/// levelsAtMost, shareAtMost; null where not known), meanLuminance, stoppedBy (samples, seconds, error, levels,
/// interrupted), device, seed (as text: 64 bits do not fit a JSON number).
std::string jsonText(const RenderReport& report);
/// The same for a person, in a few lines.
std::string plainText(const RenderReport& report);

}  // namespace pdr::app
