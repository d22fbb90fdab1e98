#include "ui/text/value_text.h"

#include "ui/text/language.h"
#include "ui/text/room_text.h"

namespace pdr::ui {

QString unitName(const ValueUnit& unit) {
    return inWords(unitText(unit));
}

QString valueNumber(const ValueUnit& unit, double voxel) {
    return number(unit.roundedValueOf(voxel), unit.decimals());
}

QString valueText(const ValueUnit& unit, double voxel) {
    return valueNumber(unit, voxel) + ' ' + unitName(unit);
}

}  // namespace pdr::ui
