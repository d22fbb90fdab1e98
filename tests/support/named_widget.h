#pragma once
/// Widgets by the names that a screen reader has for them.

#include <QWidget>

namespace pdr::test {

/// The one of that kind in `within` whose accessible name is `name`; there must be one.
template <class Widget>
Widget& named(const QWidget& within, const QString& name) {
    for (Widget* widget : within.findChildren<Widget*>())
        if (widget->accessibleName() == name)
            return *widget;
    qFatal("no widget is called %s", qPrintable(name));
}

}  // namespace pdr::test
