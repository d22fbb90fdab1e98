#pragma once
/// A dull ball in the light of some lamps.

#include <QImage>
#include <QString>
#include <vector>

#include "render/base/portable.h"

namespace pdr::ui {

/// A lamp as the viewer sees it.
struct SphereLamp {
    QString name;
    dvec3 from;         ///< where it stands, unit: to the right, up, towards the viewer
    double irradiance;  ///< of the ball's middle
    vec3 colour;        ///< linear Rec. 709
};

/// A square picture of so many pixels a side, filled by the ball, exposed for the strongest lamp.
QImage litBall(const std::vector<SphereLamp>& lamps, int side);

}  // namespace pdr::ui
