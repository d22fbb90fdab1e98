/// pdrender: the desktop.

#include <QCommandLineParser>
#include <QTimer>
#include <iostream>

#include "app/desktop.h"
#include "app/desktop/application.h"
#include "app/presets.h"
#include "render/device/device_list.h"
#include "ui/dark_theme.h"

namespace pdr::app {
namespace {

constexpr int kUsageError = 2;

struct Options {
    QString folder;      ///< empty: nothing is opened
    QString device;      ///< empty: as the last time
    int threads = 0;     ///< 0 = one per core
    QString screenshot;  ///< file for a picture of the window; empty: none
    double afterSeconds = 5;
};

/// What the command line says; a sentence and the end of the program when it says something else.
Options readOptions(const QApplication& application) {
    QCommandLineParser parser;
    parser.setApplicationDescription("Photorealistic pictures of CT volumes. Not for diagnostic use.");
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument("FOLDER", "A folder with DICOM files to open.", "[FOLDER]");
    parser.addOption(
        {"device", "Render with NAME: auto, cpu, cuda or cuda:1 (default: as chosen last, else auto).", "NAME"});
    parser.addOption({"threads", "Render with N threads, 1 to 1024 (default: one per core).", "N", "0"});
    parser.addOption({"screenshot", "Save a picture of the window as PNG and quit.", "FILE"});
    parser.addOption({"after", "Seconds to wait before the screenshot, 0 to 86400 (default 5).", "SECONDS", "5"});
    parser.process(application);

    bool threadsRight = false, secondsRight = false;
    const Options options{parser.positionalArguments().value(0), parser.value("device"),
                          parser.value("threads").toInt(&threadsRight), parser.value("screenshot"),
                          parser.value("after").toDouble(&secondsRight)};
    threadsRight = threadsRight && options.threads >= 0 && options.threads <= 1024;
    secondsRight = secondsRight && options.afterSeconds >= 0 && options.afterSeconds <= 86400;
    if (threadsRight && secondsRight && parser.positionalArguments().size() <= 1)
        return options;
    std::cerr << "pdrender: "
              << (!threadsRight   ? "--threads takes a number from 1 to 1024"
                  : !secondsRight ? "--after takes seconds from 0 to 86400"
                                  : "only one folder can be opened")
              << "\nTry 'pdrender --help'.\n";
    std::exit(kUsageError);
}

void takeScreenshot(ui::MainWindow& window, const QString& file) {
    const bool saved = window.grab().save(file, "PNG");
    if (!saved)
        std::cerr << "pdrender: " << file.toStdString()
                  << ": the screenshot cannot be written there. Choose another file.\n";
    QApplication::exit(saved ? 0 : 1);
}

/// The one asked for; else the one chosen last, and where that is there no longer, the best.
Result<std::unique_ptr<Device>> deviceFor(const Options& options) {
    if (!options.device.isEmpty())
        return openDevice(options.device.toStdString(), options.threads);
    if (auto last = openDevice(Settings().device().toStdString(), options.threads))
        return last;
    return openDevice("auto", options.threads);
}

int run(const Options& options) {
    auto presets = bundledPresets();
    if (!presets) {
        std::cerr << "pdrender: " << presets.error().text() << '\n';
        return 1;
    }
    auto device = deviceFor(options);
    if (!device) {
        std::cerr << "pdrender: " << device.error().text() << '\n';
        return 1;
    }
    Desktop desktop(*std::move(presets), *std::move(device), {}, options.threads);
    desktop.window().show();
    if (!options.folder.isEmpty())
        desktop.open(options.folder);
    if (!options.screenshot.isEmpty())
        QTimer::singleShot(int(options.afterSeconds * 1000), &desktop.window(),
                           [&] { takeScreenshot(desktop.window(), options.screenshot); });
    return QApplication::exec();
}

}  // namespace
}  // namespace pdr::app

int main(int argc, char** argv) {
    pdr::app::Application application(argc, argv);
    QApplication::setApplicationName("pdrender");
    QApplication::setApplicationVersion(PDR_VERSION);
    pdr::ui::applyDarkTheme(application);
    return pdr::app::run(pdr::app::readOptions(application));
}
