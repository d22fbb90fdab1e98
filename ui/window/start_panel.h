#pragma once
/// The panel shown in place of the image while nothing is open: ways to open a folder. Setters emit no signals.

#include <QFrame>
#include <QPushButton>
#include <QVBoxLayout>

namespace pdr::ui {

class StartPanel : public QFrame {
    Q_OBJECT

  public:
    explicit StartPanel(QWidget* parent = nullptr);

    /// Sets the recently opened folders, newest first.
    void setRecent(const QStringList& folders);
    /// Sets the folder of the example scan. Empty: there is none.
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
