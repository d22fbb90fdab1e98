#include "ui/widgets/screen_colour.h"

#include <QColorSpace>
#include <QColorTransform>

namespace pdr::ui {

QColor screenColour(vec3 linear) {
    static const QColorTransform toScreen =
        QColorSpace(QColorSpace::SRgbLinear).transformationToColorSpace(QColorSpace::SRgb);
    return toScreen.map(QColor::fromRgbF(linear.x, linear.y, linear.z));
}

vec3 linearColour(const QColor& colour) {
    static const QColorTransform toLinear =
        QColorSpace(QColorSpace::SRgb).transformationToColorSpace(QColorSpace::SRgbLinear);
    const QColor linear = toLinear.map(colour);
    return {linear.redF(), linear.greenF(), linear.blueF()};
}

}  // namespace pdr::ui
