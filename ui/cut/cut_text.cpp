#include "ui/cut/cut_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>

namespace pdr::ui {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(CutText)
};

QString millimetres(double mm) {
    return Texts::tr("%1 mm").arg(mm, 0, 'f', 1);
}

QString boxText(const ClipBox& box) {
    const dvec3 size = box.highMm - box.lowMm;
    return Texts::tr("box of %1 x %2 x %3 mm").arg(size.x, 0, 'f', 0).arg(size.y, 0, 'f', 0).arg(size.z, 0, 'f', 0);
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
    const ClipPlane& plane = clip.planes[std::size_t(handle.number)];
    return Texts::tr("%1: %2 from the middle").arg(planeName(plane), millimetres(planeOffsetMm(plane, uncut)));
}

}  // namespace pdr::ui
