#include "ui/light/light_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace pdr::ui {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(LightPanel)
};

/// Nothing for less than half a degree.
QString degreesText(double degrees, const char* positive, const char* negative) {
    const long whole = std::lround(std::abs(degrees));
    return whole == 0 ? QString() : Texts::tr(degrees > 0 ? positive : negative).arg(whole);
}

}  // namespace

QString rigName(NamedRig name) {
    switch (name) {
        case NamedRig::headlight:
            return Texts::tr("Headlight");
        case NamedRig::threePoint:
            return Texts::tr("Three points");
        case NamedRig::operatingLamp:
            return Texts::tr("Operating lamp");
        case NamedRig::rim:
            return Texts::tr("Rim");
        case NamedRig::softBox:
            return Texts::tr("Soft box");
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
        case NamedRig::sky:
            return Texts::tr("Light from all around, most from the head's side, and a sun");
    }
    return {};
}

QString lampText(const SphereLamp& lamp) {
    const bool behind = lamp.from.z < 0;
    const double sideways = glm::degrees(std::atan2(lamp.from.x, std::abs(lamp.from.z)));
    const double upwards = glm::degrees(std::asin(std::clamp(lamp.from.y, -1.0, 1.0)));
    QStringList parts{
        degreesText(sideways, QT_TRANSLATE_NOOP("LightPanel", "%1° right"),
                    QT_TRANSLATE_NOOP("LightPanel", "%1° left")),
        degreesText(upwards, QT_TRANSLATE_NOOP("LightPanel", "%1° up"), QT_TRANSLATE_NOOP("LightPanel", "%1° down")),
        behind ? Texts::tr("from behind") : QString()};
    parts.removeAll({});
    return lamp.name + ": " + (parts.isEmpty() ? Texts::tr("beside the eye") : parts.join(", "));
}

}  // namespace pdr::ui
