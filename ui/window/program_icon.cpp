#include "ui/window/program_icon.h"

/// Keeps the linker from dropping the icon resources of this static library. Qt's macro must stand outside of any
/// namespace.
static void keepIcons() {
    Q_INIT_RESOURCE(icons);
}

namespace pdr::ui {

QIcon programIcon() {
    keepIcons();
    QIcon icon;
    for (const int size : kIconSizes)
        icon.addFile(QString(":/icons/pdrender-%1.png").arg(size), {size, size});
    return icon;
}

}  // namespace pdr::ui
