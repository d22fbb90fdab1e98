#pragma once
/// The words of a command line, as Qt hands them on.

#include <QByteArray>
#include <QString>
#include <optional>

#include "render/base/result.h"

namespace pdr::app {

/// What is wrong with the words behind the program's name: Qt makes other names of what is no UTF-8, as folders of old
/// discs may be called, and would look for, or write, something else.
inline std::optional<Error> unreadableWord(int argc, char** argv) {
    for (int i = 1; i < argc; ++i)
        if (const QString read = QString::fromUtf8(argv[i]); read.toUtf8() != argv[i])
            return Error{"this name is no UTF-8", read.toStdString(),
                         "Rename it, or give the folder that holds it: below that, any name is read.",
                         ErrorKind::refused};
    return std::nullopt;
}

}  // namespace pdr::app
