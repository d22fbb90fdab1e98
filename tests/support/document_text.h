#pragma once
/// Texts of the tree, for tests that hold documents against it.

#include <QFile>
#include <QRegularExpression>
#include <QStringList>

namespace pdr::test {

/// The text of a file; empty where it cannot be read.
inline QString contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// What the first group of `pattern` catches in `text`, match by match; ^ and $ are ends of lines.
inline QStringList caught(const QString& pattern, const QString& text) {
    QStringList found;
    const QRegularExpression expression(pattern, QRegularExpression::MultilineOption);
    for (auto each = expression.globalMatch(text); each.hasNext();)
        found << each.next().captured(1);
    return found;
}

}  // namespace pdr::test
