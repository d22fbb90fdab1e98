#pragma once
/// What stands in the place of the picture as long as nothing is open: ways to open something. Setters are silent.

#include <QFrame>
#include <QPushButton>
#include <QVBoxLayout>

namespace pdr::ui {

class StartPanel : public QFrame {
    Q_OBJECT

  public:
    explicit StartPanel(QWidget* parent = nullptr);

    /// The newest first.
    void setRecent(const QStringList& folders);
    /// Empty: there is none.
    void setExample(const QString& folder);

  signals:
    void openRequested();
    void folderChosen(const QString& folder);

  private:
    QPushButton open_;
    QPushButton example_;
    QString exampleFolder_;
    QWidget recent_;
    QVBoxLayout* recentColumn_;
};

}  // namespace pdr::ui
