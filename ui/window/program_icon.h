#pragma once
/// The program's icon, for windows and task bars. It needs no plugin for SVG, which not every machine has.

#include <QIcon>

namespace pdr::ui {

inline constexpr int kIconSizes[] = {16, 32, 48, 64, 128, 256};  ///< edge lengths [pixels]

QIcon programIcon();

}  // namespace pdr::ui
