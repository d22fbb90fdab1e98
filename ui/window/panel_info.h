#pragma once
/// What a panel says of itself when it joins the window: its name, heading, key and place.

#include <QKeySequence>
#include <QString>

namespace pdr::ui {

/// Where a panel stands.
enum class PanelPlace {
    sideBar,   ///< right of the image, one panel at a time; open at first
    browser,   ///< left of the image, open at first: what there is to open; gives way in small windows
    below,     ///< below the image
    floating,  ///< over the lower part of the image
};

struct PanelInfo {
    QString name;      ///< object name, under which the panel's key is saved and its icon is found
    QString title;     ///< heading, and text of the menu entry, in the window's language
    QKeySequence key;  ///< default key, which opens and closes the panel
    PanelPlace place = PanelPlace::sideBar;
    bool fixedHeight = false;  ///< below the image: the panel's preferred height is kept, not a part of the window's
};

}  // namespace pdr::ui
