#pragma once
/// Reads texts of the source tree, for tests that compare documents with it.

#include <QFile>
#include <QRegularExpression>
#include <QStringList>

namespace pdr::test {

/// Returns the text of a file; empty if it cannot be read.
inline QString contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Returns what the first group of `pattern` captures in `text`, match by match; ^ and $ match at ends of lines.
inline QStringList caught(const QString& pattern, const QString& text) {
    QStringList found;
    const QRegularExpression expression(pattern, QRegularExpression::MultilineOption);
    for (auto each = expression.globalMatch(text); each.hasNext();)
        found << each.next().captured(1);
    return found;
}

}  // namespace pdr::test
