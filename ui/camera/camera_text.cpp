#include "ui/camera/camera_text.h"

#include <QCoreApplication>
#include <cmath>

#include "render/scene/edit/camera_edits.h"

namespace pdr::ui {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(CameraPanel)
};

/// Formats a length; more digits would exceed the precision of sharpness.
QString lengthText(double mm) {
    return Texts::tr("%1 mm").arg(mm < 10 ? QString::number(mm, 'f', 1) : QString::number(mm, 'f', 0));
}

}  // namespace

QString sharpText(const Camera& camera) {
    if (camera.apertureMm == 0)
        return Texts::tr("All is sharp. A lens blurs what lies before and behind its focus.");
    const SharpDepths depths = sharpDepths(camera);
    const double focus = camera.focusDistanceMm();
    const QString before = lengthText(focus - depths.nearMm);
    if (std::isinf(depths.farMm))
        return Texts::tr("Sharp from %1 before the focus on; it is %2 away.").arg(before, lengthText(focus));
    return Texts::tr("Sharp from %1 before the focus to %2 behind it; it is %3 away.")
        .arg(before, lengthText(depths.farMm - focus), lengthText(focus));
}

}  // namespace pdr::ui
