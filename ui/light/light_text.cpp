#include "ui/light/light_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "ui/annotation/orientation_letters.h"

namespace pdr::ui {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(LightPanel)
};

/// Returns the elevation; empty for less than half a degree.
QString heightText(double degrees) {
    const long whole = std::lround(std::abs(degrees));
    if (whole == 0)
        return {};
    return degrees > 0 ? Texts::tr("%1° from above").arg(whole) : Texts::tr("%1° from below").arg(whole);
}

/// Returns the patient's side that a lamp shines from, whatever its elevation in the view; empty if it is straight
/// above.
QString sideText(dvec3 from, const Camera& camera) {
    const dvec3 level = from.x * camera.right() - from.z * camera.forward();
    return glm::length(level) < 1e-3 ? QString()
                                     : Texts::tr("from %1").arg(QString::fromStdString(orientationLetters(level)));
}

}  // namespace

QString rigName(NamedRig name) {
    switch (name) {
        case NamedRig::headlight:
            return Texts::tr("Headlight");
        case NamedRig::threePoint:
            return Texts::tr("Three-point light");
        case NamedRig::operatingLamp:
            return Texts::tr("Operating lamp");
        case NamedRig::rim:
            return Texts::tr("Back light");
        case NamedRig::softBox:
            return Texts::tr("Large soft light");
        case NamedRig::studio:
            return Texts::tr("Studio");
        case NamedRig::sky:
            return Texts::tr("Sky");
    }
    return {};
}

QString rigTip(NamedRig name) {
    switch (name) {
        case NamedRig::headlight:
            return Texts::tr("A small lamp beside the eye: few shadows, and light in every recess");
        case NamedRig::threePoint:
            return Texts::tr("A small lamp from the side that shows form, a weak one against it, and one behind");
        case NamedRig::operatingLamp:
            return Texts::tr("Seven small lamps in a ring above: their shadows overlap softly");
        case NamedRig::rim:
            return Texts::tr("Two lamps behind: bright outlines");
        case NamedRig::softBox:
            return Texts::tr("One large panel: soft shadows");
        case NamedRig::studio:
            return Texts::tr("Eight panels as in a photographer's studio: strips behind draw the edges");
        case NamedRig::sky:
            return Texts::tr("Light from all around, most from the head's side, and a sun");
    }
    return {};
}

QString lampText(const SphereLamp& lamp, const Camera& camera) {
    constexpr double kBeside = 0.0087;  // half a degree
    const dvec3& from = lamp.from;
    if (from.z > 0 && std::hypot(from.x, from.y) < kBeside)
        return lamp.name + ": " + Texts::tr("beside the eye");
    QStringList parts{sideText(from, camera), heightText(glm::degrees(std::asin(std::clamp(from.y, -1.0, 1.0)))),
                      from.z < 0 ? Texts::tr("from behind") : QString()};
    parts.removeAll({});
    return lamp.name + ": " + parts.join(", ");
}

}  // namespace pdr::ui
