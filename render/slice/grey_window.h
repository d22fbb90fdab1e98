#pragma once
/// The window through which HU are seen as grey levels: DICOM PS3.3, C.11.2.1.2 and C.11.2.1.3.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pdr {

/// VOI LUT Function (0028,1056).
enum class VoiFunction {
    linear,       ///< "LINEAR": black up to c - 0.5 - (w - 1) / 2, white above c - 0.5 + (w - 1) / 2
    linearExact,  ///< "LINEAR_EXACT": black up to c - w / 2, white above c + w / 2
    sigmoid       ///< "SIGMOID": 1 / (1 + exp(-4 (x - c) / w))
};

struct GreyWindow {
    double centre = 50, width = 350;  ///< HU
    VoiFunction function = VoiFunction::linear;

    /// Returns whether the numbers are ones that the standard allows: finite; width >= 1 (linear) or > 0.
    bool valid() const;
    bool operator==(const GreyWindow&) const = default;
};

/// Returns the grey level of `hu`, [0, 255], rounded once, halves up. NaN is level 0.
std::uint8_t greyLevel(const GreyWindow& window, float hu);

/// Red, green and blue of what has no HU.
using Ground = std::array<std::uint8_t, 3>;

/// Returns pixels of 4 bytes each: red, green, blue, 255. Where `hu` is NaN, they have the colour of `ground`, which
/// must not be taken for black tissue.
std::vector<std::uint8_t> greyPixels(const GreyWindow& window, std::span<const float> hu, const Ground& ground = {});
/// Writes those pixels to `pixels`, 4 bytes for each of `hu`.
void paintGrey(const GreyWindow& window, std::span<const float> hu, const Ground& ground,
               std::span<std::uint8_t> pixels);

}  // namespace pdr
