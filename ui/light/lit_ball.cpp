#include "ui/light/lit_ball.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/widgets/screen_colour.h"

namespace pdr::ui {
namespace {

constexpr float kAmbient = 0.03f;  ///< relative to the strongest lamp; makes the ball visible in the dark

double strongest(const std::vector<SphereLamp>& lamps) {
    double most = 0;
    for (const SphereLamp& lamp : lamps)
        most = std::max(most, lamp.irradiance);
    return most;
}

/// Returns the screen levels of linear light in [0, 1], in even steps. Converting each pixel's colour space instead
/// would be too slow while the user drags.
std::array<int, 1024> screenLevels() {
    std::array<int, 1024> levels{};
    for (std::size_t i = 0; i < levels.size(); ++i)
        levels[i] = screenColour(vec3(float(i) / float(levels.size() - 1))).red();
    return levels;
}

QRgb exposed(vec3 radiance) {
    static const std::array levels = screenLevels();
    const auto level = [](float channel) {
        const float shown = 1 - std::exp(-channel);
        return levels[std::size_t(std::clamp(shown, 0.0f, 1.0f) * float(levels.size() - 1))];
    };
    return qRgb(level(radiance.x), level(radiance.y), level(radiance.z));
}

}  // namespace

QImage litBall(const std::vector<SphereLamp>& lamps, int side) {
    const double unit = std::max(strongest(lamps), 1e-30);
    QImage image(side, side, QImage::Format_RGB32);
    for (int y = 0; y < side; ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < side; ++x) {
            const dvec2 across = (dvec2(x, side - 1 - y) + 0.5) / (side / 2.0) - 1.0;
            const dvec3 normal(across, std::sqrt(std::max(1 - glm::dot(across, across), 0.0)));
            vec3 light(kAmbient);
            for (const SphereLamp& lamp : lamps)
                light += float(std::max(glm::dot(normal, lamp.from), 0.0) * lamp.irradiance / unit) * lamp.colour;
            line[x] = exposed(light);
        }
    }
    return image;
}

}  // namespace pdr::ui
