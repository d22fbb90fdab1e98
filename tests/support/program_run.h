#pragma once
/// Runs a program of this project to its end.

#include <QByteArray>
#include <QProcess>
#include <QStringList>

#include <functional>

#include "tests/support/patience.h"
#include "tests/support/places.h"

namespace pdr::test {

struct ProgramRun {
    int code = -1;  ///< exit code; -1: ended by a signal
    QByteArray out, err;
};

/// Runs a program and returns its output. `prepare` changes the process before it starts.
inline ProgramRun runProgram(const QString& program, const QStringList& arguments,
                             const std::function<void(QProcess&)>& prepare = {}) {
    QProcess process;
    if (prepare)
        prepare(process);
    process.start(PDR_BINARY_DIR "/bin/" + program, arguments);
    if (!process.waitForFinished(kPatience))
        qFatal("%s did not end", qPrintable(program));
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1, process.readAllStandardOutput(),
            process.readAllStandardError()};
}

}  // namespace pdr::test
