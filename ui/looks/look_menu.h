#pragma once
/// What is done with looks beside choosing them: saved, renamed, deleted, shared. Asks for names and files.

#include <QMenu>
#include <QPushButton>
#include <QString>

namespace pdr::ui {

class LookMenu : public QPushButton {
    Q_OBJECT

  public:
    explicit LookMenu(QWidget* parent = nullptr);

    /// The look that is shown; empty: one that has no name yet. `own`: the user's, who may rename and delete it.
    void setLook(const QString& name, bool own);

  signals:
    void saveWanted(const QString& name);
    void renameWanted(const QString& from, const QString& to);
    void deleteWanted(const QString& name);
    void importWanted(const QString& file);
    void exportWanted(const QString& file);

  private:
    /// Empty: the user cancelled.
    QString askForName(const QString& title);

    QString name_;
    QMenu menu_;
    QAction* rename_ = nullptr;
    QAction* delete_ = nullptr;
};

}  // namespace pdr::ui
