#pragma once
/// A part of the scan in the list.

#include <QColor>
#include <QString>

namespace pdr::ui {

struct PartRow {
    QString name;
    QColor colour;   ///< on the slices; invalid: none
    QString volume;  ///< "42 ml"; empty for the rest of the body
    QString state;   ///< "shown", "ghost", "hidden"
    QString from;    ///< "file", "program"
    QString look;    ///< look of its curve; empty: that of all tissue
    QString source;  ///< who says that it is there, in a sentence; the tool tip
    bool operator==(const PartRow&) const = default;
};

}  // namespace pdr::ui
