#include "ui/manual/manual_pages.h"

#include <QFile>
#include <QRegularExpression>
#include <algorithm>
#include <utility>

/// Registers the resources. It stands outside of any namespace, as Qt asks for.
static void initManual() {
    Q_INIT_RESOURCE(manual);
}

namespace pdr::ui {
namespace {

QString textOf(const QString& file) {
    QFile page(":/manual/" + file);
    return page.open(QIODevice::ReadOnly) ? QString::fromUtf8(page.readAll()) : QString();
}

/// Returns how often the words occur in a page; 0 unless all of them do.
qsizetype occurrences(const ManualPage& page, const QStringList& words) {
    qsizetype all = 0;
    for (const QString& word : words) {
        const qsizetype count = page.text.count(word, Qt::CaseInsensitive);
        if (count == 0)
            return 0;
        all += count;
    }
    return all;
}

}  // namespace

QList<ManualPage> manualPages() {
    initManual();
    const QString contents = textOf("index.md");
    QList<ManualPage> pages{{"index.md", "Contents", contents}};
    static const QRegularExpression row("^\\| \\[([^\\]]+)\\]\\(([\\w-]+\\.md)\\) \\|",
                                        QRegularExpression::MultilineOption);
    for (auto each = row.globalMatch(contents); each.hasNext();) {
        const QRegularExpressionMatch match = each.next();
        pages.append({match.captured(2), match.captured(1), textOf(match.captured(2))});
    }
    return pages;
}

QString manualUrl(const QString& file) {
    return "qrc:/manual/" + file;
}

QList<ManualPage> pagesWith(const QList<ManualPage>& pages, const QString& words) {
    const QStringList all = words.split(' ', Qt::SkipEmptyParts);
    if (all.isEmpty())
        return pages;
    QList<std::pair<qsizetype, ManualPage>> found;
    for (const ManualPage& page : pages)
        if (const qsizetype count = occurrences(page, all); count > 0)
            found.append({count, page});
    std::ranges::stable_sort(found, std::ranges::greater(), [](const auto& one) { return one.first; });
    QList<ManualPage> sorted;
    for (const auto& one : std::as_const(found))
        sorted << one.second;
    return sorted;
}

}  // namespace pdr::ui
