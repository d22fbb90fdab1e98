#pragma once
/// The command line of `pdrender`.

#include <QString>
#include <QStringList>

#include <optional>

namespace pdr::app {

struct DesktopOptions {
    QString folder;            ///< empty: nothing is opened
    QString device;            ///< empty: the one chosen in the last run
    int threads = 0;           ///< 0 = one per core
    int keptMegabytes = 1024;  ///< most memory of the images of earlier scenes [MiB]
    QString screenshot;        ///< file for an image of the window; empty: none
    double afterSeconds = 5;
    /// The exit code if nothing is left to do: 0 after --help and --version, 2 after a message about wrong usage.
    std::optional<int> answered;
};

/// Parses `arguments`, which begin with the program's name. Needs a QCoreApplication, but no display. Help and version
/// go to standard output.
DesktopOptions desktopOptions(const QStringList& arguments);

}  // namespace pdr::app
