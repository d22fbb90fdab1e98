#include "ui/text/value_text.h"

#include "ui/text/language.h"
#include "ui/text/room_text.h"

namespace pdr::ui {

QString unitName(const ValueUnit& unit) {
    return inWords(unitText(unit));
}

QString valueNumber(const ValueUnit& unit, double voxel, double part) {
    const ValueUnit finer{unit.isHu, unit.name, unit.step * part, unit.zero};
    return number(finer.roundedValueOf(voxel / part), finer.decimals());
}

QString valueText(const ValueUnit& unit, double voxel, double part) {
    return valueNumber(unit, voxel, part) + ' ' + unitName(unit);
}

}  // namespace pdr::ui
