#include "ui/text/cut_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/text/language.h"

namespace pdr::ui {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(CutText)
};

QString millimetres(double mm) {
    return Texts::tr("%1 mm").arg(number(mm, 1));
}

QString boxText(const ClipBox& box) {
    const dvec3 size = box.highMm - box.lowMm;
    return Texts::tr("box of %1 x %2 x %3 mm").arg(size.x, 0, 'f', 0).arg(size.y, 0, 'f', 0).arg(size.z, 0, 'f', 0);
}

/// Returns what each face cuts off; faces that cut off less than the last digit shown are left out.
QStringList boxTexts(const Clip& clip, const std::optional<Uncut>& uncut) {
    constexpr double kWritten = 0.05;  // [mm]
    QStringList texts;
    if (!clip.box)
        return texts;
    if (!uncut)
        return {boxText(*clip.box)};
    for (int face = 0; face < 6; ++face)
        if (const double mm = cutOffMm(clip, *uncut, face); mm >= kWritten)
            texts << QString("%1 %2").arg(faceName(face), millimetres(mm));
    return texts;
}

}  // namespace

QString faceName(int face) {
    const std::array names{Texts::tr("right"), Texts::tr("left"), Texts::tr("front"),
                           Texts::tr("back"),  Texts::tr("feet"), Texts::tr("head")};
    return names[std::size_t(face)];
}

QString planeName(const ClipPlane& plane) {
    const std::array names{Texts::tr("Sagittal"), Texts::tr("Coronal"), Texts::tr("Axial")};
    const dvec3 normal = glm::abs(glm::normalize(plane.normal));
    const int axis = normal.x > normal.y && normal.x > normal.z ? 0 : normal.y > normal.z ? 1 : 2;
    const int degrees = int(std::lround(glm::degrees(std::acos(std::min(normal[axis], 1.0)))));
    const QString& name = names[std::size_t(axis)];
    return degrees == 0 ? name : Texts::tr("%1, tilted by %2°").arg(name).arg(degrees);
}

/// Returns the position of a plane.
static QString placeOf(const ClipPlane& plane, const Uncut& uncut) {
    return Texts::tr("%1: %2 from the middle").arg(planeName(plane), millimetres(planeOffsetMm(plane, uncut)));
}

QString handleText(const Clip& clip, const Uncut& uncut, CutHandle handle) {
    switch (handle.kind) {
        case CutHandle::Kind::face:
            return Texts::tr("%1: %2 cut off")
                .arg(faceName(handle.number), millimetres(cutOffMm(clip, uncut, handle.number)));
        case CutHandle::Kind::box:
            return boxText(cropBox(clip, uncut));
        case CutHandle::Kind::offset:
        case CutHandle::Kind::tilt:
            break;
    }
    return placeOf(clip.planes[std::size_t(handle.number)], uncut);
}

QString cutText(const Clip& clip, const std::optional<Uncut>& uncut) {
    QStringList texts = boxTexts(clip, uncut);
    for (const ClipPlane& plane : clip.planes)
        texts << (uncut ? placeOf(plane, *uncut) : planeName(plane));
    if (!clip.freehand.empty())
        texts << Texts::tr("%1 drawn").arg(clip.freehand.size());
    return texts.isEmpty() ? QString() : Texts::tr("cut: %1").arg(texts.join("; "));
}

}  // namespace pdr::ui
