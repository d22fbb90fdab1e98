#pragma once
/// A menu of the recently opened folders, with the choice whether the program remembers them. Setters emit no signals.

#include <QMenu>

namespace pdr::ui {

class RecentMenu : public QMenu {
    Q_OBJECT

  public:
    explicit RecentMenu(QWidget* parent = nullptr);

    /// Sets the folders, newest first. There are none where `remembered` is false.
    void setFolders(const QStringList& folders, bool remembered);

  signals:
    void folderChosen(const QString& folder);
    void rememberChosen(bool remembered);
    void forgetRequested();
};

}  // namespace pdr::ui
