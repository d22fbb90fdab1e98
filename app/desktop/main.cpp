/// pdrender, the desktop program. Exit codes: 0 for success, 1 for an error, 2 for wrong usage.

#include <QFile>
#include <QPixmap>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include "app/command_line/command_words.h"
#include "app/desktop/application.h"
#include "app/desktop/desktop.h"
#include "app/desktop/options.h"
#include "app/looks/looks.h"
#include "app/program/program.h"
#include "app/rendering/first_device.h"
#include "app/rendering/power_supply.h"
#include "render/base/version.h"
#include "ui/text/language.h"
#include "ui/text/room_text.h"
#include "ui/theme/theme.h"

namespace pdr::app {
namespace {

constexpr const char* kNoDisplay =
    "pdrender: there is no display to open a window on. Start it on a desktop, or render to files with pdrender-cli, "
    "which needs none.\n";

/// Saves `image` as a PNG. It shows a patient, so only the owner may read a new file.
bool saveForOwner(const QPixmap& image, const QString& path) {
    QFile file(path);
    const bool isNew = !file.exists();
    return file.open(QFile::WriteOnly) && (!isNew || file.setPermissions(QFile::ReadOwner | QFile::WriteOwner)) &&
           image.save(&file, "PNG") && file.flush();
}

void takeScreenshot(ui::MainWindow& window, const QString& file) {
    const bool saved = saveForOwner(window.grab(), file);
    if (!saved)
        std::cerr << "pdrender: " << file.toStdString()
                  << ": the screenshot cannot be written there. Choose another file.\n";
    QApplication::exit(saved ? 0 : 1);
}

int run(const DesktopOptions& options) {
    auto looks = bundledLooks();
    if (!looks) {
        std::cerr << "pdrender: " << looks.error().text() << '\n';
        return 1;
    }
    RenderBridge* bridge = nullptr;  // there before the device gets its first scene
    auto first = firstDevice(options.device.toStdString(), Settings().device().toStdString(), options.threads,
                             [&bridge](bool begins) { bridge->tellPreparing(begins); });
    if (!first) {
        std::cerr << "pdrender: " << first.error().text() << '\n';
        return 1;
    }
    Desktop desktop(*std::move(looks), std::move(first->device), {}, options.threads, kPowerSupplies);
    bridge = &desktop.bridge();
    bridge->setKeptMemory(std::size_t(options.keptMegabytes) << 20);
    desktop.window().show();
    if (!first->notice.empty())
        desktop.window().message().showNotice(ui::inWords(first->notice));
    if (!options.folder.isEmpty())
        // inside the event loop, which catches exceptions
        QTimer::singleShot(0, &desktop.window(), [&] { desktop.open(options.folder); });
    if (!options.screenshot.isEmpty())
        QTimer::singleShot(int(options.afterSeconds * 1000), &desktop.window(),
                           [&] { takeScreenshot(desktop.window(), options.screenshot); });
    return QApplication::exec();
}

// ---- with a display, and without

bool anyOf(int argc, char** argv, std::initializer_list<std::string_view> words) {
    return std::any_of(argv + 1, argv + argc,
                       [&](std::string_view word) { return std::ranges::find(words, word) != words.end(); });
}

bool hasDisplay(int argc, char** argv) {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        if (const char* value = std::getenv(name); value && *value)
            return true;
    return anyOf(argc, argv, {"-platform", "--platform", "-display", "--display"});
}

/// Answers --help and --version, and reports wrong usage before it reports the missing display.
int runWithoutWindow(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    keepNumbersPlain();
    if (const auto options = desktopOptions(QCoreApplication::arguments()); options.answered)
        return *options.answered;
    std::fputs(kNoDisplay, stderr);
    return 1;
}

/// Ends the program with a message and exit code 1 if Qt cannot reach the display; Qt would end it with a signal.
void endWhereQtGivesUp(QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type != QtFatalMsg)
        return;
    std::fprintf(stderr, "%s%s\n", kNoDisplay, message.section('\n', 0, 0).toUtf8().constData());
    std::_Exit(1);
}

int runWithWindow(int argc, char** argv) {
    const QtMessageHandler usual = qInstallMessageHandler(endWhereQtGivesUp);
    giveMemoryBack();
    qputenv("QT_NO_GLIB", "1");  // GLib ends the program if memory is short
    Application application(argc, argv);
    keepNumbersPlain();
    qInstallMessageHandler(usual);
    QApplication::setApplicationName("pdrender");
    QApplication::setApplicationVersion(PDR_VERSION);
    QApplication::setDesktopFileName("pdrender");  // a task bar shows its icon under Wayland
    const DesktopOptions options = desktopOptions(QApplication::arguments());
    if (options.answered)
        return *options.answered;
    ui::speak(application, ui::languageFor(Settings().language()));
    ui::applyTheme(application, Settings().theme());
    return run(options);
}

}  // namespace
}  // namespace pdr::app

int main(int argc, char** argv) {
    using namespace pdr::app;
    return runProgram("pdrender", [&] {
        if (const auto unreadable = unreadableWord(argc, argv)) {
            std::cerr << "pdrender: " << unreadable->text() << '\n';
            return 2;
        }
        const bool asks = anyOf(argc, argv, {"-h", "--help", "--help-all", "-v", "--version"});
        return asks || !hasDisplay(argc, argv) ? runWithoutWindow(argc, argv) : runWithWindow(argc, argv);
    });
}
