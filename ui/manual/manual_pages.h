#pragma once
/// The pages of the manual, which the program carries inside it, and the search in them.

#include <QList>
#include <QString>

namespace pdr::ui {

struct ManualPage {
    QString file;   ///< name of the Markdown file, "window.md"
    QString title;  ///< title in the table of contents
    QString text;   ///< Markdown
};

/// Returns all pages in the order of the table of contents, which comes first.
QList<ManualPage> manualPages();

/// Returns the URL under which the program carries a file of the manual.
QString manualUrl(const QString& file);

/// Returns the pages that contain all words of `words`, in any case and order; those with most occurrences come first.
/// All pages, in their order, if there is no word.
QList<ManualPage> pagesWith(const QList<ManualPage>& pages, const QString& words);

}  // namespace pdr::ui
