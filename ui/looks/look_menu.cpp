#include "ui/looks/look_menu.h"

#include <QInputDialog>
#include <QMessageBox>

#include "ui/widgets/file_dialogs.h"

namespace pdr::ui {

LookMenu::LookMenu(QWidget* parent) : QPushButton(parent) {
    setText(tr("&My looks"));
    setAccessibleName(tr("Save and share looks"));
    setToolTip(tr("Save the look as it is now, rename and delete your own, share them as files"));
    setFocusPolicy(Qt::TabFocus);
    setMenu(&menu_);
    menu_.addAction(tr("&Save this look..."), this, [this] {
        if (const QString name = askForName(tr("Save this look")); !name.isEmpty())
            emit saveWanted(name);
    });
    rename_ = menu_.addAction(tr("&Rename..."), this, [this] {
        if (const QString name = askForName(tr("Rename the look")); !name.isEmpty())
            emit renameWanted(name_, name);
    });
    delete_ = menu_.addAction(tr("&Delete"), this, [this] {
        if (QMessageBox::question(this, tr("Delete the look"), tr("Delete \"%1\"?").arg(name_)) == QMessageBox::Yes)
            emit deleteWanted(name_);
    });
    menu_.addSeparator();
    menu_.addAction(tr("&Import..."), this, [this] {
        if (const QString file = askForLook(this); !file.isEmpty())
            emit importWanted(file);
    });
    menu_.addAction(tr("&Export this look..."), this, [this] {
        if (const QString file = askWhereToShare(this, name_); !file.isEmpty())
            emit exportWanted(file);
    });
    setLook({}, false);
}

void LookMenu::setLook(const QString& name, bool own) {
    name_ = name;
    rename_->setEnabled(own);
    delete_->setEnabled(own);
}

QString LookMenu::askForName(const QString& title) {
    return QInputDialog::getText(this, title, tr("Name:"), QLineEdit::Normal, name_).trimmed();
}

}  // namespace pdr::ui
