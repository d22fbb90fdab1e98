#pragma once
/// The language of the window: texts, numbers, and what Qt's own dialogs say.

#include <QCoreApplication>
#include <QString>
#include <QStringList>
#include <string>

namespace pdr::ui {

/// Codes of the languages that there are, English first: "en", "de", "es".
const QStringList& languages();
/// "Deutsch"
QString languageName(const QString& code);
/// One of them for what the user has chosen, or where that is empty or none of them, for what the system speaks.
QString languageFor(const QString& chosen);

/// Lets `application` speak it from now on: widgets that are made later, not those that are there.
void speak(QCoreApplication& application, const QString& code);

/// Numbers as people of the window's language write them, without marks between thousands.
QString number(double value, int decimals);
/// Of what a room without Qt has written: "0.5 (0.4 to 0.6)".
QString localNumber(const std::string& text);

}  // namespace pdr::ui
