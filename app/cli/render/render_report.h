#pragma once
/// Report that `pdrender-cli render` prints to standard output when an image is written.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "render/accuracy/bias.h"
#include "render/base/portable.h"
#include "render/device/device.h"
#include "render/prepare/warnings.h"
#include "render/session/batch_render.h"
#include "render/tiles/node_checks.h"

namespace pdr::app {

struct RenderReport {
    std::vector<std::filesystem::path> outputs;
    ivec2 size{0};  ///< pixels
    std::uint64_t seed = 0;
    DeviceInfo device;
    BatchResult result;
    std::vector<Warning> warnings;  ///< warnings about the scene
    std::vector<Bias> biases;
    NodeChecks checks = {};  ///< what was checked of the samples of render nodes
};

/// Returns a JSON object: outputs, width, height, samplesPerPixel (fewest of a pixel), meanSamplesPerPixel,
/// mostSamplesPerPixel, nodes (null: none took part; else tiles, checkedShare, foundOneIn20 and foundOneIn200, the
/// probabilities that a node with one false tile in 20 or 200 would have been found), rejectedSamples, warnings (names:
/// overDense), biases (each with cause, ofComputing, text; brightness and levels with value, low, high; levelsAtMost,
/// shareAtMost; null where not known), health, seconds, samplesPerSecond (of all pixels together), relativeError and
/// displayError (null while unknown), tissuePixels, unseenTissue, unseenShare, meanLuminance, stoppedBy (samples,
/// seconds, error, levels, interrupted), device, seed (as text: 64 bits do not fit a JSON number).
std::string jsonText(const RenderReport& report);
/// Returns the report for a person, in a few lines.
std::string plainText(const RenderReport& report);

}  // namespace pdr::app
