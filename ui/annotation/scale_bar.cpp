#include "ui/annotation/scale_bar.h"

#include <QCoreApplication>

#include "ui/text/language.h"

namespace pdr::ui {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(Annotations)
};

}  // namespace

std::optional<ScaleBar> scaleBar(const Camera& camera, double height, double longest) {
    Camera centred = camera;
    centred.focusMm = 0;  // the depth of the camera's target, whatever is in focus
    const double mmPerPixel = centred.heightInFocusMm() / height;
    double mm = 0;
    for (double power = 0.01; power < 1e6; power *= 10)
        for (const double digit : {1, 2, 5})
            if (digit * power <= longest * mmPerPixel)
                mm = digit * power;
    if (mm == 0 || mm > 1e5)
        return std::nullopt;
    const QString length = number(mm, mm < 0.1 ? 2 : mm < 1 ? 1 : 0);
    const bool everywhere = camera.type == Camera::Type::orthographic;
    return ScaleBar{mm / mmPerPixel,
                    everywhere ? Texts::tr("%1 mm").arg(length) : Texts::tr("%1 mm at the centre's depth").arg(length)};
}

}  // namespace pdr::ui
