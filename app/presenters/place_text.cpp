#include "app/presenters/place_text.h"

#include <cmath>

#include "render/slice/reslice.h"
#include "ui/text/language.h"

namespace pdr::app {
namespace {

/// Returns a coordinate with the letter of the side on which it lies: "L 12.5".
QString sideText(double mm, const char* positive, const char* negative) {
    return QString("%1 %2").arg(mm < 0 ? negative : positive, ui::number(std::abs(mm), 1));
}

}  // namespace

QString placeText(dvec3 placeMm) {
    return sideText(placeMm.x, "L", "R") + "  " + sideText(placeMm.y, "P", "A") + "  " + sideText(placeMm.z, "H", "F") +
           " mm";
}

double huAt(const Volume& volume, dvec3 placeMm) {
    const SlicePlane pixel = SlicePlane::around(placeMm, {1, 0, 0}, {0, 1, 0}, 1, ivec2(1));
    return double(reslice(volume, pixel)->hu.front());
}

}  // namespace pdr::app
