#pragma once
/// Icons drawn with lines in the colour of the theme's text, sharp at any size and scale.

#include <QIcon>

namespace pdr::ui {

/// Returns whether there is an icon called `name`.
bool hasLineIcon(const QString& name);
/// Returns the icon called `name`: the object name of the action that it stands for. Names without an icon
/// get that of a panel. The icon follows a change of the theme.
QIcon lineIcon(const QString& name);

}  // namespace pdr::ui
