#pragma once
/// The panel shown in place of the image while nothing is open: ways to open a scan, what was opened last, and what can
/// be dropped. Setters emit no signals.

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace pdr::ui {

class StartPanel : public QFrame {
    Q_OBJECT

  public:
    explicit StartPanel(QWidget* parent = nullptr);

    /// Sets the recently opened folders, newest first; the first ones are shown.
    void setRecent(const QStringList& folders);
    /// Sets the files of recent plans, newest first; the first ones are shown.
    void setRecentPlans(const QStringList& files);
    /// Sets the folder of the example scan. Empty: there is none.
    void setExample(const QString& folder);

  signals:
    void openRequested();
    void folderChosen(const QString& folder);
    void planChosen(const QString& file);

  private:
    /// A heading with a button for each of some files or folders; hidden if there are none.
    struct Recent {
        QWidget box;
        QVBoxLayout* column = nullptr;
    };

    void head(Recent& recent, const QString& heading);
    void fill(Recent& recent, const QStringList& paths, void (StartPanel::*chosen)(const QString&));

    QPushButton open_;
    QPushButton example_;
    QString exampleFolder_;
    Recent plans_, folders_;
};

}  // namespace pdr::ui
