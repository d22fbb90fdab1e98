#pragma once
/// The language of the window: its texts, its number format, and the texts of Qt's own dialogs.

#include <QCoreApplication>
#include <QString>
#include <QStringList>
#include <string>

namespace pdr::ui {

/// Returns the codes of the available languages, English first: "en", "de", "es".
const QStringList& languages();
/// Returns a language's own name: "Deutsch".
QString languageName(const QString& code);
/// Returns the language to use: the chosen one if available, else the system's if available, else the first of
/// languages().
QString languageFor(const QString& chosen);

/// Switches `application` to that language. Only widgets created afterwards use it.
void speak(QCoreApplication& application, const QString& code);

/// Formats a number as usual in the window's language, without thousands separators.
QString number(double value, int decimals);
/// Localises a number formatted without Qt: "0.5 (0.4 to 0.6)".
QString localNumber(const std::string& text);

}  // namespace pdr::ui
