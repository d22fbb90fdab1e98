#include "ui/light/light_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace pdr::ui {
namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("pdr::ui::LightPanel", text);
}

/// Nothing for less than half a degree.
QString degreesText(double degrees, const char* positive, const char* negative) {
    const long whole = std::lround(std::abs(degrees));
    return whole == 0 ? QString() : tr(degrees > 0 ? positive : negative).arg(whole);
}

}  // namespace

QString rigName(NamedRig name) {
    switch (name) {
        case NamedRig::headlight:
            return tr("Headlight");
        case NamedRig::threePoint:
            return tr("Three points");
        case NamedRig::operatingLamp:
            return tr("Operating lamp");
        case NamedRig::rim:
            return tr("Rim");
        case NamedRig::softBox:
            return tr("Soft box");
        case NamedRig::sky:
            return tr("Sky");
    }
    return {};
}

QString rigTip(NamedRig name) {
    switch (name) {
        case NamedRig::headlight:
            return tr("A small lamp beside the eye: few shadows, and light in every recess");
        case NamedRig::threePoint:
            return tr("A small lamp from the side that shows form, a weak one against it, and one behind");
        case NamedRig::operatingLamp:
            return tr("Seven small lamps in a ring above: their shadows overlap softly");
        case NamedRig::rim:
            return tr("Two lamps behind: bright outlines");
        case NamedRig::softBox:
            return tr("One large panel: soft shadows");
        case NamedRig::sky:
            return tr("Light from all around, most from the head's side, and a sun");
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
        behind ? tr("from behind") : QString()};
    parts.removeAll({});
    return lamp.name + ": " + (parts.isEmpty() ? tr("beside the eye") : parts.join(", "));
}

}  // namespace pdr::ui
