#include "ui/view/error_colours.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/base/srgb.h"

namespace pdr::ui {
namespace {

// OKLab coordinates of the scale: all of its colours are inside the gamut of a screen.
constexpr double kDarkest = 0.3, kLightest = 0.92, kChroma = 0.13;
constexpr double kFirstHue = 285, kLastHue = 460;     ///< degrees: from violet over red and orange to yellow
constexpr QRgb kUnknown = qRgba(128, 128, 128, 160);  ///< translucent grey; no colour of the scale is grey

QRgb fromOkLab(double lightness, double a, double b) {
    const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    const auto level = [](double light) { return int(std::lround(255 * srgbFromLinear(std::clamp(light, 0.0, 1.0)))); };
    return qRgb(level(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
                level(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
                level(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s));
}

QRgb colourOf(std::uint8_t bin) {
    if (bin == kNoTissueBin)
        return qRgba(0, 0, 0, 0);
    if (bin > kLastBin)
        return kUnknown;
    const double place = double(bin - kFirstBin) / (kLastBin - kFirstBin);
    const double hue = std::lerp(kFirstHue, kLastHue, place) * std::numbers::pi / 180;
    return fromOkLab(std::lerp(kDarkest, kLightest, place), kChroma * std::cos(hue), kChroma * std::sin(hue));
}

}  // namespace

QColor errorColour(double levels) {
    return QColor::fromRgba(colourOf(levelBinOf(float(levels))));
}

QList<QRgb> errorColours() {
    QList<QRgb> colours;
    for (int bin = 0; bin < 256; ++bin)
        colours << colourOf(std::uint8_t(bin));
    return colours;
}

}  // namespace pdr::ui
