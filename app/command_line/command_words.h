#pragma once
/// Check that the words of a command line are valid UTF-8.

#include <QByteArray>
#include <QString>
#include <optional>

#include "render/base/result.h"

namespace pdr::app {

/// Returns an error for the first word after the program's name that is not valid UTF-8, as names on old discs may be;
/// null if there is none. Qt would change such a name, and the program would read or write another path.
inline std::optional<Error> unreadableWord(int argc, char** argv) {
    for (int i = 1; i < argc; ++i)
        if (const QString read = QString::fromUtf8(argv[i]); read.toUtf8() != argv[i])
            return Error{"this name is no UTF-8", read.toStdString(),
                         "Rename it, or give the folder that holds it: below that, any name is read.",
                         ErrorKind::refused};
    return std::nullopt;
}

}  // namespace pdr::app
