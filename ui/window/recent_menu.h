#pragma once
/// The folders that were opened last, in a menu, with the choice whether they are remembered at all. Setters are
/// silent.

#include <QMenu>

namespace pdr::ui {

class RecentMenu : public QMenu {
    Q_OBJECT

  public:
    explicit RecentMenu(QWidget* parent = nullptr);

    /// `folders`: the newest first; none where `remembered` is false.
    void setFolders(const QStringList& folders, bool remembered);

  signals:
    void folderChosen(const QString& folder);
    void rememberChosen(bool remembered);
    void forgetRequested();
};

}  // namespace pdr::ui
