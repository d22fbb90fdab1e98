#pragma once
/// Values of the libraries as Qt's.

#include <QString>
#include <algorithm>
#include <filesystem>
#include <string>

namespace pdr::ui {

/// A path for the screen or for Qt's file dialogs.
inline QString toQt(const std::filesystem::path& path) {
    return QString::fromStdU16String(path.u16string());
}

/// A phrase of the libraries as a sentence: a capital in front (unless a file's name stands there), a full stop behind.
inline QString sentence(const std::string& phrase) {
    QString text = QString::fromStdString(phrase).trimmed();
    if (text.isEmpty())
        return text;
    const QString first = text.section(' ', 0, 0);
    if (std::all_of(first.begin(), first.end(), [](QChar letter) { return letter.isLetter(); }))
        text[0] = text[0].toUpper();
    return text.endsWith('.') ? text : text + '.';
}

inline std::filesystem::path fromQt(const QString& path) {
    return path.toStdU16String();
}

}  // namespace pdr::ui
