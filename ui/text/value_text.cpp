#include "ui/text/value_text.h"

#include <cmath>

#include "ui/text/language.h"
#include "ui/text/room_text.h"

namespace pdr::ui {

QString unitName(const ValueUnit& unit) {
    return inWords(unitText(unit));
}

QString valueNumber(const ValueUnit& unit, double voxel) {
    const double last = std::pow(10.0, unit.decimals());
    return number(std::round(unit.valueOf(voxel) * last) / last + 0.0, unit.decimals());
}

QString valueText(const ValueUnit& unit, double voxel) {
    return valueNumber(unit, voxel) + ' ' + unitName(unit);
}

}  // namespace pdr::ui
