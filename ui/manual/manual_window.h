#pragma once
/// The manual in a window of its own: its pages, a search in all of them, and the page that is read. It needs no
/// network and no files beside the program.

#include <QLineEdit>
#include <QListWidget>
#include <QTextBrowser>
#include <QToolButton>

#include "ui/manual/manual_pages.h"

namespace pdr::ui {

class ManualWindow : public QWidget {
    Q_OBJECT

  public:
    explicit ManualWindow(QWidget* parent = nullptr);

    /// Shows a page, and the place in it that `link` names after "#": "window.md", "accuracy.md#the-error-map". Does
    /// nothing if the manual has no such page.
    void open(const QString& link);
    /// Returns the name of the file that is shown.
    QString page() const { return browser_.source().fileName(); }

  private:
    void layOut();
    void search(const QString& words);
    void follow(const QUrl& link);
    void markWords();
    void scrollTo(const QString& anchor);

    QList<ManualPage> pages_;
    QLineEdit words_;
    QToolButton back_;
    QListWidget list_;
    QTextBrowser browser_;
};

}  // namespace pdr::ui
