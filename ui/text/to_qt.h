#pragma once
/// Conversions between the libraries' types and Qt's.

#include <QString>
#include <filesystem>

namespace pdr::ui {

/// Converts a path for the screen or for Qt's file dialogs.
inline QString toQt(const std::filesystem::path& path) {
    return QString::fromStdU16String(path.u16string());
}

inline std::filesystem::path fromQt(const QString& path) {
    return path.toStdU16String();
}

}  // namespace pdr::ui
