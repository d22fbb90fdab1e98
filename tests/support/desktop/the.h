#pragma once
/// Finds the parts of a window by their class.

#include <QObject>

namespace pdr::test {

/// Returns the object of class `One` within `window`, e.g. a panel; there must be one.
template <class One>
One& the(const QObject& window) {
    if (auto* one = window.findChild<One*>())
        return *one;
    qFatal("the window has no %s", One::staticMetaObject.className());
}

}  // namespace pdr::test
