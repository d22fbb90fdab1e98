#pragma once
/// What `pdrender` was asked for on its command line.

#include <QString>
#include <QStringList>

#include <optional>

namespace pdr::app {

struct DesktopOptions {
    QString folder;      ///< empty: nothing is opened
    QString device;      ///< empty: as the last time
    int threads = 0;     ///< 0 = one per core
    QString screenshot;  ///< file for a picture of the window; empty: none
    double afterSeconds = 5;
    /// The exit code where all is said already: 0 after --help and --version, 2 after a sentence about wrong usage.
    std::optional<int> answered;
};

/// `arguments` begin with the program's name. Needs a QCoreApplication, no display. Help and version go to standard
/// output.
DesktopOptions desktopOptions(const QStringList& arguments);

}  // namespace pdr::app
