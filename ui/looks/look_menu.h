#pragma once
/// The button and menu that save, rename, delete, import and export looks. It asks for names and files.

#include <QMenu>
#include <QPushButton>
#include <QString>

namespace pdr::ui {

class LookMenu : public QPushButton {
    Q_OBJECT

  public:
    explicit LookMenu(QWidget* parent = nullptr);

    /// Sets the current look; empty: a look that has no name yet. `own`: saved by the user, who may rename and delete
    /// it.
    void setLook(const QString& name, bool own);

  signals:
    void saveWanted(const QString& name);
    void renameWanted(const QString& from, const QString& to);
    void deleteWanted(const QString& name);
    void importWanted(const QString& file);
    void exportWanted(const QString& file);

  private:
    /// Asks for the name of a look. Empty: the user cancelled.
    QString askForName(const QString& title);

    QString name_;
    QMenu menu_;
    QAction* rename_ = nullptr;
    QAction* delete_ = nullptr;
};

}  // namespace pdr::ui
