#include "app/desktop/options.h"

#include <QCommandLineParser>

#include <cstdio>

#include "render/base/version.h"

namespace pdr::app {
namespace {

constexpr int kUsageError = 2;

void describe(QCommandLineParser& parser) {
    parser.setApplicationDescription(
        "Photorealistic images of CT volumes. Not for diagnostic use.\n"
        "Needs a display; pdrender-cli renders to files without one.");
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(
        "FOLDER", "A folder with DICOM files to open, or a scan in one file (ZIP, NIfTI, NRRD, MetaImage).",
        "[FOLDER]");
    parser.addOption(
        {"device", "Render with NAME: auto, cpu, cuda or cuda:1 (default: as chosen last, else auto).", "NAME"});
    parser.addOption({"threads", "Render with N threads, 1 to 1024 (default: one per core).", "N", "0"});
    parser.addOption(
        {"keep", "Keep up to MB of images of earlier views and looks, 0 to 1048576 (default 1024).", "MB", "1024"});
    parser.addOption({"screenshot", "Save an image of the window as PNG and quit.", "FILE"});
    parser.addOption({"after", "Seconds to wait before the screenshot, 0 to 86400 (default 5).", "SECONDS", "5"});
}

DesktopOptions answered(int code) {
    DesktopOptions options;
    options.answered = code;
    return options;
}

DesktopOptions usageError(const QString& what) {
    std::fprintf(stderr, "pdrender: %s\nTry 'pdrender --help'.\n", what.toUtf8().constData());
    return answered(kUsageError);
}

}  // namespace

DesktopOptions desktopOptions(const QStringList& arguments) {
    QCommandLineParser parser;
    describe(parser);
    if (!parser.parse(arguments))
        return usageError(parser.errorText());
    if (parser.isSet("help") || parser.isSet("help-all")) {
        std::fputs(parser.helpText().toUtf8().constData(), stdout);
        return answered(0);
    }
    if (parser.isSet("version")) {
        std::puts("PD-Render " PDR_VERSION);
        return answered(0);
    }
    bool threadsRight = false, keptRight = false, secondsRight = false;
    DesktopOptions options;
    options.folder = parser.positionalArguments().value(0);
    options.device = parser.value("device");
    options.threads = parser.value("threads").toInt(&threadsRight);
    options.keptMegabytes = parser.value("keep").toInt(&keptRight);
    options.screenshot = parser.value("screenshot");
    options.afterSeconds = parser.value("after").toDouble(&secondsRight);
    if (!threadsRight || options.threads < 0 || options.threads > 1024)
        return usageError("--threads takes a number from 1 to 1024");
    if (!keptRight || options.keptMegabytes < 0 || options.keptMegabytes > 1 << 20)
        return usageError("--keep takes megabytes from 0 to 1048576");
    if (!secondsRight || !(options.afterSeconds >= 0 && options.afterSeconds <= 86400))
        return usageError("--after takes seconds from 0 to 86400");
    if (parser.positionalArguments().size() > 1)
        return usageError("only one folder can be opened");
    return options;
}

}  // namespace pdr::app
