/// Measures how long slices take to follow the hand, in the real window while the image is in the making: from the
/// event to the end of the painting of the slice that answers it.
///   scrolling FOLDER [--steps N] [--size WIDTHxHEIGHT] [--threads N]
/// FOLDER holds a CT. Its slices are interpolated to 600. Prints how long all three slices take to appear after their
/// key; then a line for each direction of the wheel and one for dragging the crosshair, with N events (default 300), 60
/// a second: milliseconds (median, 95 in 100, 99 in 100, most), the size of the slices, and the processor time of the
/// window's thread with one event (99 in 100, most).

#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <cmath>
#include <cstdio>
#include <deque>

#include "app/cli/scan/scanned_volume.h"
#include "app/desktop/desktop.h"
#include "app/looks/looks.h"
#include "app/presenters/slices_presenter.h"
#include "app/program/program.h"
#include "tests/support/desktop/event_times.h"
#include "ui/text/to_qt.h"
#include "ui/theme/theme.h"

namespace pdr::app {
namespace {

constexpr int kSlices = 600;

/// Returns `volume` with kSlices slices over the same length.
std::shared_ptr<const Volume> withManySlices(const Volume& volume) {
    const VolumeGeometry& scan = volume.geometry();
    const std::size_t perSlice = std::size_t(scan.size.x) * std::size_t(scan.size.y);
    dvec3 spacing = scan.spacingMm();
    spacing.z *= double(scan.size.z - 1) / (kSlices - 1);
    Voxels voxels(perSlice * kSlices);
    for (int k = 0; k < kSlices; ++k) {
        const double z = k * double(scan.size.z - 1) / (kSlices - 1);
        const int below = std::min(int(z), scan.size.z - 2);
        const std::int16_t* lower = volume.voxels().data() + std::size_t(below) * perSlice;
        for (std::size_t i = 0; i < perSlice; ++i)
            voxels[std::size_t(k) * perSlice + i] =
                std::int16_t(std::lround(std::lerp(double(lower[i]), double(lower[i + perSlice]), z - below)));
    }
    return std::make_shared<const Volume>(
        VolumeGeometry::aligned({scan.size.x, scan.size.y, kSlices}, spacing, dvec3(scan.patientFromIndex[3])),
        std::move(voxels));
}

/// Waits for the slices of a view, and times those that it waits for.
class Watched {
  public:
    explicit Watched(ui::SliceView& view) : view(view) {}

    /// Waits for a slice through `placeMm`, which was asked for just now.
    void expect(dvec3 placeMm, double nowMs) { pending_.push_back({placeMm, nowMs}); }

    /// Answers what the painted slice answers: the newest event whose place it contains, and all before.
    void painted(double nowMs) {
        if (!view.slice())
            return;
        const SlicePlane& plane = view.slice()->plane;
        const auto answered = std::find_if(pending_.rbegin(), pending_.rend(), [&](const Pending& event) {
            return std::abs(glm::dot(event.placeMm - plane.middleMm(), plane.normal())) < 1e-6;
        });
        for (auto left = pending_.rend() - answered; left > 0; --left) {
            latencies.push_back(nowMs - pending_.front().atMs);
            pending_.pop_front();
        }
    }
    bool waits() const { return !pending_.empty(); }

    ui::SliceView& view;
    std::vector<double> latencies;  ///< [ms]

  private:
    struct Pending {
        dvec3 placeMm;
        double atMs;
    };
    std::deque<Pending> pending_;
};

/// Times events as its base does, and tells the watched views when they have been painted.
class WatchingApplication : public test::TimedApplication {
  public:
    using TimedApplication::TimedApplication;

    bool notify(QObject* receiver, QEvent* event) override {
        const bool taken = TimedApplication::notify(receiver, event);
        if (event->type() == QEvent::Paint)
            for (Watched& one : watched)
                if (receiver == &one.view)
                    one.painted(nowMs());
        return taken;
    }
    double nowMs() const { return 1e-6 * double(clock_.nsecsElapsed()); }

    std::vector<Watched> watched;

  private:
    QElapsedTimer clock_ = [] {
        QElapsedTimer clock;
        clock.start();
        return clock;
    }();
};

WatchingApplication& application() {
    return *static_cast<WatchingApplication*>(qApp);
}

double at(std::vector<double>& values, double share) {
    std::ranges::sort(values);
    return values.empty() ? 0 : values[std::min(std::size_t(share * double(values.size())), values.size() - 1)];
}

/// Runs the event loop until `done` says so, asked sixty times a second. Unlike QTest::qWait() it never sleeps past an
/// event.
void runUntil(const std::function<bool()>& done) {
    QEventLoop loop;
    QTimer timer;
    timer.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer, &QTimer::timeout, [&] {
        if (done())
            loop.quit();
    });
    timer.start(1000 / 60);
    loop.exec();
}

bool allAnswered() {
    return std::ranges::none_of(application().watched, &Watched::waits);
}

/// Calls `edit` with 0, 1, 2, ... sixty times a second; each edit asks for slices through its place in those views that
/// it returns.
void repeat(int steps, const std::function<std::vector<std::size_t>(int)>& edit, const Document& document) {
    WatchingApplication& app = application();
    int done = 0;
    runUntil([&] {
        if (done == steps)
            return allAnswered();
        const double start = app.nowMs();
        const std::vector<std::size_t> changed = edit(done++);
        for (const std::size_t view : changed)
            app.watched[view].expect(document.plan().navigation.crosshairMm, start);
        return false;
    });
}

/// Prints what was measured under that name, and begins anew.
void report(const char* name) {
    WatchingApplication& app = application();
    std::vector<double> all;
    ivec2 size(0);
    for (Watched& one : app.watched) {
        if (!one.latencies.empty())
            size = one.view.sizeInPixels();
        all.insert(all.end(), one.latencies.begin(), one.latencies.end());
        one.latencies.clear();
    }
    std::printf(
        "%-20s %4zu slices of %4d x %-4d   median %5.1f   p95 %5.1f   p99 %5.1f   most %5.1f ms   "
        "window's thread: p99 %4.1f, most %4.1f ms\n",
        name, all.size(), size.x, size.y, at(all, 0.5), at(all, 0.95), at(all, 0.99), at(all, 1),
        app.at(0.99, &test::EventTime::processorMs), app.at(1, &test::EventTime::processorMs));
    std::fflush(stdout);
    app.times.clear();
}

void wheel(ui::SliceView& view, int steps) {
    const QPointF middle = view.rect().center();
    QWheelEvent event(middle, view.mapToGlobal(middle), {}, QPoint(0, 120 * steps), Qt::NoButton, {}, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(&view, &event);
}

void drag(ui::SliceView& view, QEvent::Type type, QPointF place) {
    const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, place, view.mapToGlobal(place), button, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&view, &event);
}

/// Shows the slices, and reports how long they take to appear.
void showSlices(Desktop& desktop) {
    WatchingApplication& app = application();
    app.times.clear();
    const double start = app.nowMs();
    desktop.window().findChild<QAction*>("nextLayout")->trigger();
    for (Watched& one : app.watched)
        one.expect(desktop.document().plan().navigation.crosshairMm, start);
    runUntil(allAnswered);
    report("all three, by L");
    desktop.window().findChild<QAction*>("nextLayout")->trigger();  // four views: the larger ones
    QTest::qWait(500);
}

int run(const std::filesystem::path& folder, int steps, QSize size, int threads) {
    QTemporaryDir settings;
    const auto scanned = scannedVolume(folder, {});
    if (!scanned) {
        std::printf("%s\n", scanned.error().text().c_str());
        return 1;
    }
    Desktop desktop(*bundledLooks(), makeCpuDevice(threads), settings.filePath("settings.ini"), threads);
    desktop.window().resize(size);
    desktop.window().show();
    desktop.window().start().hide();
    auto& slices = desktop.presenter<SlicesPresenter>();
    for (const AnatomicalPlane plane : kAnatomicalPlanes)
        application().watched.emplace_back(slices.view(plane));
    desktop.document().open(withManySlices(*scanned->volume));
    const auto image = [&] { return desktop.bridge().lastFrame() && !desktop.bridge().lastFrame()->coarse; };
    runUntil(image);
    showSlices(desktop);
    for (const AnatomicalPlane plane : kAnatomicalPlanes) {
        ui::SliceView& view = slices.view(plane);
        const auto scroll = [&](int i) {
            wheel(view, i % 100 < 50 ? 1 : -1);
            return std::vector{std::size_t(plane)};
        };
        repeat(steps, scroll, desktop.document());
        report(planeName(plane));
    }
    ui::SliceView& axial = slices.view(AnatomicalPlane::axial);
    const QPointF middle = axial.rect().center();
    drag(axial, QEvent::MouseButtonPress, middle);
    QTest::qWait(200);
    application().times.clear();
    const auto circle = [&](int i) {
        drag(axial, QEvent::MouseMove, middle + 60 * QPointF(std::sin(0.07 * (i + 1)), 1 - std::cos(0.05 * (i + 1))));
        return std::vector<std::size_t>{1, 2};
    };
    repeat(steps, circle, desktop.document());
    report("crosshair, two views");
    drag(axial, QEvent::MouseButtonRelease, middle);
    return 0;
}

}  // namespace
}  // namespace pdr::app

int main(int argc, char** argv) {
    pdr::app::giveMemoryBack();
    pdr::app::WatchingApplication application(argc, argv);
    pdr::ui::applyTheme(application, pdr::ui::ThemeChoice::dark);
    QCommandLineParser parser;
    parser.addPositionalArgument("FOLDER", "a folder with a CT");
    parser.addOption({"steps", "of each gesture", "N", "300"});
    parser.addOption({"size", "of the window, in pixels", "WIDTHxHEIGHT", "1480x920"});
    parser.addOption({"threads", "0: one per core", "N", "0"});
    parser.addHelpOption();
    parser.process(application);
    const QStringList size = parser.value("size").split('x');
    if (parser.positionalArguments().size() != 1 || size.size() != 2)
        parser.showHelp(2);
    return pdr::app::run(pdr::ui::fromQt(parser.positionalArguments()[0]), parser.value("steps").toInt(),
                         QSize(size[0].toInt(), size[1].toInt()), parser.value("threads").toInt());
}
