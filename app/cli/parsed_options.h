#pragma once
/// Parses the options of a command, and lists them for its help.

#include <QCommandLineParser>
#include <QStringList>

#include <string>

#include "render/base/result.h"

namespace pdr::app {

/// Parses `arguments` of `command` with the options that `describe` adds, and passes them to `read` unless they ask for
/// help. Errors are usage errors.
template <class Options>
Result<Options> parsed(const QString& command, const QStringList& arguments, void (*describe)(QCommandLineParser&),
                       void (*read)(const QCommandLineParser&, Options&)) {
    QCommandLineParser parser;
    describe(parser);
    if (!parser.parse(QStringList(command) + arguments))
        return Error{parser.errorText().toStdString(), command.toStdString(), ""};
    Options options;
    options.help = parser.isSet("help");
    try {
        if (!options.help)
            read(parser, options);
    } catch (const Error& error) {
        return error;
    }
    return options;
}

/// Returns the list of the options that `describe` adds.
inline std::string optionsText(void (*describe)(QCommandLineParser&)) {
    QCommandLineParser parser;
    describe(parser);
    QString text = parser.helpText();
    text.remove(0, text.indexOf('\n') + 1);  // the parser's usage line lacks the command word
    return text.toStdString();
}

}  // namespace pdr::app
