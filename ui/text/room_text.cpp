#include "ui/text/room_text.h"

#include <QCoreApplication>
#include <algorithm>

#include "ui/text/language.h"

namespace pdr::ui {
namespace {

QString translated(const std::string& english) {
    return QCoreApplication::translate("rooms", english.c_str());
}

/// Returns the words with a capital at the beginning (unless they begin with a file's name) and a full stop.
QString asSentence(QString words) {
    words = words.trimmed();
    if (words.isEmpty())
        return words;
    const QString first = words.section(' ', 0, 0);
    if (std::all_of(first.begin(), first.end(), [](QChar letter) { return letter.isLetter(); }))
        words[0] = words[0].toUpper();
    return words.endsWith('.') ? words : words + '.';
}

QString argument(const Text& text);

/// Returns `pattern`, already translated, with %1 to %9 replaced in one pass: a file's name may contain "%2".
QString filled(const QString& pattern, const std::vector<Text>& arguments) {
    QString text;
    for (qsizetype i = 0; i < pattern.size(); ++i) {
        const int place = pattern[i] == '%' && i + 1 < pattern.size() ? pattern[i + 1].digitValue() : 0;
        if (place >= 1 && std::size_t(place) <= arguments.size()) {
            text += argument(arguments[std::size_t(place - 1)]);
            ++i;
        } else {
            text += pattern[i];
        }
    }
    return text;
}

QString argument(const Text& text) {
    switch (text.kind()) {
        case Text::Kind::pattern:
            return filled(translated(text.pattern()), text.arguments());
        case Text::Kind::number:
            return localNumber(text);
        case Text::Kind::sentence:
            return asSentence(argument(text.arguments().front()));
        case Text::Kind::words:
            break;
    }
    return QString::fromStdString(text);
}

}  // namespace

/// Translates plain strings too: they may be sentences without arguments. An argument may be the name of a file and is
/// not translated.
QString inWords(const Text& text) {
    return text.kind() == Text::Kind::words ? translated(text) : argument(text);
}

QString sentence(const Text& text) {
    return asSentence(inWords(text));
}

}  // namespace pdr::ui
