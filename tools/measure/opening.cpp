/// Measures what it takes to open a series in the real window: wall time and processor time since the folder was given,
/// and memory, at each step on the way.
///   opening FOLDER [--until S] [--threads N]
/// FOLDER holds a CT. Prints a line when headers are read, voxels are in memory, the first image stands (small
/// pixels), the first full image, each mask of a part and each image of the gallery; after S seconds (default 10) the
/// window is closed, and the last line says how long the program took to free everything.

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>
#include <memory>

#include "app/desktop/desktop.h"
#include "app/looks/looks.h"
#include "app/presenters/looks_presenter.h"
#include "app/presenters/series_presenter.h"
#include "app/presenters/visible_presenter.h"
#include "app/program/program.h"
#include "render/device/device_list.h"
#include "tests/support/processor_time.h"
#include "ui/theme/theme.h"

namespace pdr::app {
namespace {

/// Megabytes of a line of /proc/self/status, such as "VmHWM".
double megabytes(const QByteArray& name) {
    QFile status("/proc/self/status");
    if (status.open(QIODevice::ReadOnly))
        for (const QByteArray& line : status.readAll().split('\n'))
            if (line.startsWith(name))
                return line.simplified().split(' ').at(1).toDouble() / 1024;
    return 0;
}

class Log {
  public:
    Log() {
        clock_.start();
        std::printf("%8s %8s %8s %8s\n", "clock", "cpu", "now MB", "peak MB");
    }
    /// Begins to count anew.
    void restart() {
        clock_.restart();
        spent_ = {};
    }
    void operator()(const char* step, const QString& detail = {}) const {
        std::printf("%8.2f %8.2f %8.0f %8.0f  %s%s\n", double(clock_.elapsed()) / 1000, spent_.seconds(),
                    megabytes("VmRSS"), megabytes("VmHWM"), step, qPrintable(detail));
        std::fflush(stdout);
    }

  private:
    QElapsedTimer clock_;
    test::ProcessorTime spent_;
};

void logSteps(Desktop& desktop, const Log& log) {
    const ImportJob& import = desktop.presenter<SeriesPresenter>().import();
    QObject::connect(&import, &ImportJob::scanned, [&log] { log("headers read"); });
    QObject::connect(&import, &ImportJob::loaded, [&log] { log("voxels and table in memory"); });
    QObject::connect(&desktop.presenter<VisiblePresenter>().masks(), &MaskJob::made,
                     [&log] { log("part told from the body"); });
    QObject::connect(&desktop.presenter<LooksPresenter>().images(), &LookImages::made,
                     [&log](int look) { log("gallery: look ", QString::number(look)); });
    QObject::connect(&desktop.bridge(), &RenderBridge::frameReady,
                     [&log, coarse = false, full = false](const std::shared_ptr<const Frame>& frame) mutable {
                         if (frame->rgba.empty() || full || (frame->coarse && coarse))
                             return;
                         (frame->coarse ? coarse : full) = true;
                         log(frame->coarse ? "first image, " : "first full image, ",
                             QString("%1 pixels wide").arg(frame->size.x));
                     });
}

int run(const QString& folder, double until, int threads) {
    Log log;
    {
        const QTemporaryDir settings;
        Desktop desktop(*bundledLooks(), makeCpuDevice(threads), settings.filePath("settings.ini"), threads);
        desktop.window().resize(1480, 920);
        desktop.window().show();
        logSteps(desktop, log);
        log("window");
        log.restart();
        desktop.open(folder);
        QTest::qWait(int(until * 1000));
        log("closing");
    }
    log("closed");
    return 0;
}

}  // namespace
}  // namespace pdr::app

int main(int argc, char** argv) {
    pdr::app::giveMemoryBack();
    QApplication application(argc, argv);
    pdr::ui::applyTheme(application, pdr::ui::ThemeChoice::dark);
    QCommandLineParser parser;
    parser.addPositionalArgument("FOLDER", "a folder with a CT");
    parser.addOption({"until", "seconds until the window is closed", "S", "10"});
    parser.addOption({"threads", "0: one per core", "N", "0"});
    parser.addHelpOption();
    parser.process(application);
    if (parser.positionalArguments().size() != 1)
        parser.showHelp(2);
    return pdr::app::run(parser.positionalArguments()[0], parser.value("until").toDouble(),
                         parser.value("threads").toInt());
}
