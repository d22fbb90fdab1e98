#include "ui/manual/manual_window.h"

#include <QDesktopServices>
#include <QHBoxLayout>
#include <QRegularExpression>
#include <QScrollBar>
#include <QShortcut>
#include <QSplitter>
#include <QTextBlock>

namespace pdr::ui {
namespace {

/// Returns the anchor of a heading as Markdown readers form it: "The error map" is "the-error-map".
QString anchorOf(const QString& heading) {
    static const QRegularExpression notKept("[^\\w\\- ]", QRegularExpression::UseUnicodePropertiesOption);
    return QString(heading).remove(notKept).toLower().replace(' ', '-');
}

}  // namespace

ManualWindow::ManualWindow(QWidget* parent) : QWidget(parent, Qt::Window), pages_(manualPages()) {
    setWindowTitle(tr("Manual of PD-Render"));
    words_.setPlaceholderText(tr("Search the manual"));
    words_.setAccessibleName(tr("Search the manual"));
    words_.setClearButtonEnabled(true);
    back_.setText(tr("Back"));
    back_.setToolTip(tr("Returns to the page that was read before."));
    back_.setEnabled(false);
    list_.setAccessibleName(tr("Pages of the manual"));
    browser_.setAccessibleName(tr("Page"));
    browser_.setOpenLinks(false);
    browser_.setSearchPaths({":/manual"});
    layOut();
    connect(&words_, &QLineEdit::textChanged, this, &ManualWindow::search);
    connect(&back_, &QToolButton::clicked, &browser_, &QTextBrowser::backward);
    connect(&list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (item)
            open(item->data(Qt::UserRole).toString());
    });
    connect(&browser_, &QTextBrowser::anchorClicked, this, &ManualWindow::follow);
    connect(&browser_, &QTextBrowser::backwardAvailable, &back_, &QToolButton::setEnabled);
    connect(new QShortcut(QKeySequence::Find, this), &QShortcut::activated, &words_, qOverload<>(&QWidget::setFocus));
    connect(new QShortcut(Qt::Key_Escape, this), &QShortcut::activated, this, &QWidget::close);
    search({});
}

void ManualWindow::layOut() {
    auto* contents = new QWidget;
    auto* column = new QVBoxLayout(contents);
    column->setContentsMargins(0, 0, 0, 0);
    auto* row = new QHBoxLayout;
    row->addWidget(&words_, 1);
    row->addWidget(&back_);
    column->addLayout(row);
    column->addWidget(&list_, 1);
    auto* both = new QSplitter;
    both->addWidget(contents);
    both->addWidget(&browser_);
    both->setStretchFactor(1, 1);
    both->setSizes({280, 720});
    (new QVBoxLayout(this))->addWidget(both);
    resize(1000, 720);
}

/// Lists the pages that contain all words, and shows the first with the words marked.
void ManualWindow::search(const QString& words) {
    const QSignalBlocker silent(&list_);
    list_.clear();
    for (const ManualPage& page : pagesWith(pages_, words)) {
        auto* item = new QListWidgetItem(page.title, &list_);
        item->setData(Qt::UserRole, page.file);
    }
    if (list_.count() == 0) {
        auto* none = new QListWidgetItem(tr("No page has all of these words."), &list_);
        none->setFlags(Qt::NoItemFlags);
        return;
    }
    list_.setCurrentRow(0);
    open(list_.currentItem()->data(Qt::UserRole).toString());
}

void ManualWindow::open(const QString& link) {
    const QString file = link.section('#', 0, 0), anchor = link.section('#', 1);
    const auto is = [&](const ManualPage& page) { return page.file == file; };
    if (std::none_of(pages_.begin(), pages_.end(), is))
        return;
    if (page() != file)
        browser_.setSource(manualUrl(file), QTextDocument::MarkdownResource);
    markWords();
    scrollTo(anchor);
}

/// Follows a link to another page, or to a place in this one. Pages in the Internet open in the system's browser; files
/// of the source are not here.
void ManualWindow::follow(const QUrl& link) {
    if (link.scheme().startsWith("http"))
        QDesktopServices::openUrl(link);
    else
        open((link.fileName().isEmpty() ? page() : link.fileName()) + '#' + link.fragment());
}

/// Marks all occurrences of the words that are searched for.
void ManualWindow::markWords() {
    QList<QTextEdit::ExtraSelection> marks;
    for (const QString& word : words_.text().split(' ', Qt::SkipEmptyParts))
        for (QTextCursor at = browser_.document()->find(word); !at.isNull(); at = browser_.document()->find(word, at)) {
            QTextEdit::ExtraSelection mark{at, {}};
            mark.format.setBackground(palette().highlight());
            mark.format.setForeground(palette().highlightedText());
            marks << mark;
        }
    browser_.setExtraSelections(marks);
    if (!marks.isEmpty()) {
        QTextCursor first = marks.front().cursor;
        first.clearSelection();
        browser_.setTextCursor(first);
    }
}

/// Scrolls to the heading of that anchor; does nothing if there is none.
void ManualWindow::scrollTo(const QString& anchor) {
    for (QTextBlock block = browser_.document()->begin(); block.isValid() && !anchor.isEmpty(); block = block.next())
        if (block.blockFormat().headingLevel() > 0 && anchorOf(block.text()) == anchor) {
            browser_.verticalScrollBar()->setValue(browser_.verticalScrollBar()->maximum());
            browser_.setTextCursor(QTextCursor(block));
            return browser_.ensureCursorVisible();
        }
}

}  // namespace pdr::ui
