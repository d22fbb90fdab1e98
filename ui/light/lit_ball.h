#pragma once
/// An image of a diffuse ball lit by some lamps.

#include <QImage>
#include <QString>
#include <vector>

#include "render/base/portable.h"

namespace pdr::ui {

/// A lamp as the viewer sees it.
struct SphereLamp {
    QString name;
    dvec3 from;         ///< direction towards the lamp, a unit vector: to the right, up, towards the viewer
    double irradiance;  ///< irradiance at the middle of the ball
    vec3 colour;        ///< linear Rec. 709
};

/// Returns a square image, `side` pixels wide, filled by the ball and exposed for the strongest lamp.
QImage litBall(const std::vector<SphereLamp>& lamps, int side);

}  // namespace pdr::ui
