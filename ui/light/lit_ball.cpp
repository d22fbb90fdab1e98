#include "ui/light/lit_ball.h"

#include <algorithm>
#include <cmath>

#include "ui/tissue/curve_painter.h"

namespace pdr::ui {
namespace {

constexpr float kAmbient = 0.03f;  ///< of the brightest, so that the ball is seen in the dark

double strongest(const std::vector<SphereLamp>& lamps) {
    double most = 0;
    for (const SphereLamp& lamp : lamps)
        most = std::max(most, lamp.irradiance);
    return most;
}

QColor exposed(vec3 radiance) {
    return screenColour(vec3(1) - vec3(std::exp(-radiance.x), std::exp(-radiance.y), std::exp(-radiance.z)));
}

}  // namespace

QImage litBall(const std::vector<SphereLamp>& lamps, int side) {
    const double unit = std::max(strongest(lamps), 1e-30);
    QImage image(side, side, QImage::Format_RGB32);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const dvec2 across = (dvec2(x, side - 1 - y) + 0.5) / (side / 2.0) - 1.0;
            const dvec3 normal(across, std::sqrt(std::max(1 - glm::dot(across, across), 0.0)));
            vec3 light(kAmbient);
            for (const SphereLamp& lamp : lamps)
                light += float(std::max(glm::dot(normal, lamp.from), 0.0) * lamp.irradiance / unit) * lamp.colour;
            image.setPixelColor(x, y, exposed(light));
        }
    return image;
}

}  // namespace pdr::ui
