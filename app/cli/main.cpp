/// Entry point of pdrender-cli with its commands info, looks, render, merge, slice, parts, plan, accuracy, effects,
/// replay, cluster, example. Exit codes: 0 on success, 1 on an error, 2 on wrong usage.

#include <QByteArray>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QLocale>
#include <QStringList>

#include <cstdio>
#include <cstdlib>
#include <memory>

#include "app/cli/accuracy/accuracy_command.h"
#include "app/cli/batch/merge_command.h"
#include "app/cli/cluster/cluster_command.h"
#include "app/cli/effects/effects_command.h"
#include "app/cli/failed.h"
#include "app/cli/parts/parts_command.h"
#include "app/cli/plan/plan_command.h"
#include "app/cli/render/annotating.h"
#include "app/cli/render/render_command.h"
#include "app/cli/render/replay_command.h"
#include "app/cli/scan/example_command.h"
#include "app/cli/scan/info_command.h"
#include "app/cli/scene/looks_command.h"
#include "app/cli/slice/slice_command.h"
#include "app/command_line/command_words.h"
#include "app/program/program.h"
#include "render/base/version.h"

namespace pdr::app {
namespace {

constexpr const char* kHelp =
    "pdrender-cli: volume rendering of CT that says how right the image is. Not for diagnostic use.\n"
    "\n"
    "  pdrender-cli info FOLDER [--json]                      list the series in a folder of DICOM files\n"
    "  pdrender-cli looks                                     list how a scan can look\n"
    "  pdrender-cli render FOLDER|SCENE.json -o FILE ...      render an image (.png, .exr)\n"
    "  pdrender-cli merge FOLDER|SCENE.json FILM... -o FILE   make an image of the films of its shares\n"
    "  pdrender-cli slice FOLDER|SCENE.json --plane PLANE -o FILE ...  write a slice as an image or as HU\n"
    "  pdrender-cli parts FOLDER|SCENE.json --labels FILE ... list the parts that a label map marks in a scan\n"
    "  pdrender-cli plan FILE [--scan FOLDER] ...             list what a plan has measured, export it, render it\n"
    "  pdrender-cli accuracy FOLDER|SCENE.json -o DIR ...     measure what accuracy costs in time\n"
    "  pdrender-cli effects FOLDER|SCENE.json ...             list what the image needs, why, and at what cost\n"
    "  pdrender-cli replay FOLDER|SCENE.json --pixel X,Y ...  tell how one sample came about, event by event\n"
    "  pdrender-cli cluster start --slurm N --listen PORT ... start render nodes as a job of Slurm\n"
    "  pdrender-cli example FOLDER ...                        write an example CT series\n"
    "  pdrender-cli help COMMAND                              explain a command; the same as COMMAND --help\n"
    "  pdrender-cli --version                                 say which version this is\n"
    "\n"
    "FOLDER may also be a ZIP archive of DICOM or volume files, or one volume: NIfTI, NRRD or MetaImage.\n"
    "Exit codes: 0 done, 1 error, 2 wrong usage.\n";

int usageError(const QString& what) {
    std::fprintf(stderr, "pdrender-cli: %s\n\n%s", what.toUtf8().constData(), kHelp);
    return 2;
}

int run(QStringList arguments) {
    if (arguments.isEmpty())
        return usageError("say what to do");
    QString command = arguments.takeFirst();
    if (command == "help" && !arguments.isEmpty()) {
        command = arguments.takeFirst();
        arguments = {"--help"};
    }
    if (command == "info")
        return runInfo(arguments);
    if (command == "looks")
        return runLooks(arguments);
    if (command == "render")
        return runRender(arguments);
    if (command == "merge")
        return runMerge(arguments);
    if (command == "slice")
        return runSlice(arguments);
    if (command == "parts")
        return runParts(arguments);
    if (command == "plan")
        return runPlan(arguments);
    if (command == "accuracy")
        return runAccuracy(arguments);
    if (command == "effects")
        return runEffects(arguments);
    if (command == "replay")
        return runReplay(arguments);
    if (command == "example")
        return runExample(arguments);
    if (command == "cluster")
        return runCluster(arguments);
    if (command == "--version" || command == "-v") {
        std::puts("PD-Render " PDR_VERSION);
        return 0;
    }
    if (command == "--help" || command == "-h" || command == "help") {
        std::fputs(kHelp, stdout);
        return 0;
    }
    return usageError("there is no command \"" + command + "\"");
}

constexpr const char* kNoLetters =
    "pdrender-cli: letters cannot be painted on this machine. Install Qt's platform plugins (qt6-qpa-plugins), or add "
    "--annotations none.\n";

/// Exits with an explanation on a fatal message of Qt. Qt would otherwise end the program with a signal if it has no
/// platform plugin to paint with.
void endWhereQtGivesUp(QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type != QtFatalMsg)
        return;
    std::fprintf(stderr, "%s%s\n", kNoLetters, message.section('\n', 0, 0).toUtf8().constData());
    std::_Exit(1);
}

/// Returns only if there is memory for Qt and the list of fonts; throws std::bad_alloc if not. Where memory ends within
/// its files, fontconfig 2.14 ends the program, at the latest when Qt is about to end: it reads them then if nothing
/// has before.
void reserveFonts() {
    constexpr qsizetype kBytes = 16 << 20;
    QByteArray(kBytes, Qt::Uninitialized);
}

/// Creates the Qt application. Letters require fonts, and fonts require a QGuiApplication, which works without a
/// display. Numbers are formatted as in English in every locale.
std::unique_ptr<QCoreApplication> applicationFor(int& argc, char** argv) {
    QLocale::setDefault(QLocale::c());
    if (!mayWriteLetters(argc, argv))
        return std::make_unique<QCoreApplication>(argc, argv);
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QtMessageHandler usual = qInstallMessageHandler(endWhereQtGivesUp);
    reserveFonts();
    auto application = std::make_unique<QGuiApplication>(argc, argv);
    QFontDatabase::families();
    qInstallMessageHandler(usual);
    return application;
}

}  // namespace
}  // namespace pdr::app

int main(int argc, char** argv) {
    return pdr::app::runProgram("pdrender-cli", [&] {
        const std::unique_ptr<QCoreApplication> application = pdr::app::applicationFor(argc, argv);
        pdr::app::keepNumbersPlain();
        if (const auto unreadable = pdr::app::unreadableWord(argc, argv)) {
            pdr::app::failed(*unreadable);
            return 2;
        }
        return pdr::app::run(QCoreApplication::arguments().mid(1));
    });
}
