#include "ui/window/recent_menu.h"

namespace pdr::ui {

RecentMenu::RecentMenu(QWidget* parent) : QMenu(tr("Open &recent"), parent) {
    setToolTipsVisible(true);
    setFolders({}, false);
}

void RecentMenu::setFolders(const QStringList& folders, bool remembered) {
    clear();
    for (const QString& folder : folders) {
        QString text = folder;
        connect(addAction(text.replace('&', "&&")), &QAction::triggered, this,
                [this, folder] { emit folderChosen(folder); });
    }
    addSeparator();
    QAction* remember = addAction(tr("&Remember folders"));
    remember->setCheckable(true);
    remember->setChecked(remembered);
    remember->setToolTip(
        tr("Folders are often called after patients: anyone who uses this account can read the list."));
    connect(remember, &QAction::triggered, this, &RecentMenu::rememberChosen);
    QAction* forget = addAction(tr("&Forget these folders"));
    forget->setEnabled(!folders.isEmpty());
    connect(forget, &QAction::triggered, this, &RecentMenu::forgetRequested);
}

}  // namespace pdr::ui
