#include "ui/window/program_icon.h"

/// Qt's macro must stand outside of any namespace; without it the linker drops the resources of a static library.
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
