#pragma once
/// What a panel says of itself when it joins the window: its name, heading, key and place.

#include <QKeySequence>
#include <QString>

namespace pdr::ui {

/// Where a panel stands. Which panels give way where room is short, and which are open at first, follows from it.
enum class PanelPlace {
    browser,   ///< left of the image, open at first: what there is to open
    looks,     ///< right of the image, open at first, above the editors
    editor,    ///< right of the image, below the looks; one editor is open at a time
    settings,  ///< right of the image; gives way to the editors
    below,     ///< below the image
    floating,  ///< over the lower part of the image
};

struct PanelInfo {
    QString name;      ///< object name, under which the window's state and the panel's key are saved
    QString title;     ///< heading, and text of the menu entry, in the window's language
    QKeySequence key;  ///< default key, which opens and closes the panel
    PanelPlace place = PanelPlace::editor;
    bool fixedHeight = false;  ///< below the image: the panel's preferred height is kept, not a part of the window's
};

}  // namespace pdr::ui
