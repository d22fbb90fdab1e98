#pragma once
/// Finds widgets by the names that a screen reader reads.

#include <QWidget>

namespace pdr::test {

/// Returns the widget of that kind in `within` whose accessible name is `name`; there must be one.
template <class Widget>
Widget& named(const QWidget& within, const QString& name) {
    for (Widget* widget : within.findChildren<Widget*>())
        if (widget->accessibleName() == name)
            return *widget;
    qFatal("no widget is called %s", qPrintable(name));
}

}  // namespace pdr::test
