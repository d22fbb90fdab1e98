#include "app/presenters/place_text.h"

#include <cmath>

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

double huAt(const SlicedScan& scan, dvec3 placeMm) {
    const auto pixel = reslice(scan, SlicePlane::around(placeMm, {1, 0, 0}, {0, 1, 0}, 1, ivec2(1)));
    return pixel ? double(pixel->hu.front()) : double(kNotArrived);
}

}  // namespace pdr::app
