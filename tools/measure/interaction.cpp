/// Measures how long an image takes to follow an interaction, in the real window: from the event to the end of the
/// painting of the first image that shows it.
///   interaction FOLDER [--seconds S] [--threads N] [--only GESTURE] [--each]
/// FOLDER holds a CT. Each gesture takes S seconds (default 10), with events as a mouse sends them, 125 a second: a
/// drag that rotates (turn), one of the brightness, one of a node of the tissue's opacity (node). Then single edits,
/// views and looks, each after a rest of a second; and views, looks and tissue undone and redone (undo), where an image
/// answers only if it has all samples that it had before it was left. Prints a line each: events that were answered,
/// milliseconds (median, 99 in 100, most), images a second, the median of their widths, and the ratio of the processor
/// time of the whole program to wall time; and below it how long single events kept the window busy, in wall time and
/// in its own processor time, and the parts of the way from an event to the first image of its scene, the median and 99
/// in 100 of each: until the render thread took the scene, until the device had it, the samples, making the image, and
/// until it was painted. With --each it prints the same for each first image of a scene as it comes.

#include <QApplication>
#include <QCommandLineParser>
#include <QMouseEvent>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

#include "app/desktop/desktop.h"
#include "app/looks/looks.h"
#include "app/program/program.h"
#include "tests/support/desktop/event_times.h"
#include "tests/support/desktop/the.h"
#include "ui/looks/look_panel.h"
#include "ui/theme/theme.h"
#include "ui/tissue/tissue_panel.h"

namespace pdr::app {
namespace {

constexpr int kBetweenEventsMs = 8;

double at(std::vector<double> values, double share) {
    if (values.empty())
        return 0;
    std::ranges::sort(values);
    return values[std::min(std::size_t(share * double(values.size())), values.size() - 1)];
}

/// An edit that no image has shown yet.
struct Unanswered {
    double atMs;
    std::uint64_t revision;
    Display display;
    std::uint64_t samples;  ///< least samples per pixel of a full image that answers; 0: any image does

    bool isAnsweredBy(const Frame& frame) const {
        const bool isGood = samples == 0 || (!frame.coarse && frame.status.samplesPerPixel >= samples);
        return revision <= frame.revision && display == frame.display && isGood;
    }
};

/// The parts of the way from an event to its image.
constexpr std::array<const char*, 5> kParts{"waited", "begun", "samples", "image", "painted"};

class Stopwatch {
  public:
    Stopwatch(Desktop& desktop, bool each) : desktop_(desktop), each_(each) {
        QObject::connect(&desktop.bridge(), &RenderBridge::frameReady,
                         [this](const std::shared_ptr<const Frame>& frame) { painted(*frame); });
    }

    /// Makes an edit, and times its image, which must have so many samples per pixel.
    void time(const std::function<void()>& edit, std::uint64_t samples = 0) {
        const double start = nowMs();
        edit();
        const Document& document = desktop_.document();
        unanswered_.push_back({start, document.scene().revision, document.display(), samples});
    }

    /// Calls `edit` with 0, 1, 2, ... every `ms` milliseconds, for `seconds`.
    void repeat(double seconds, int ms, const std::function<void(int)>& edit) {
        const double end = nowMs() + 1e3 * seconds;
        for (int i = 0; nowMs() < end; ++i) {
            const double next = nowMs() + ms;
            time([&] { edit(i); });
            QTest::qWait(std::max(int(next - nowMs()), 0));
        }
    }

    /// Prints what was measured under that name, and begins anew.
    void report(const char* name) {
        const double seconds = 1e-3 * (nowMs() - beganMs_);
        std::printf(
            "%-22s %4zu answered   median %6.1f ms   p99 %6.1f ms   most %6.1f ms   %5.1f images/s   "
            "%4.0f px wide   cpu %.2f\n",
            name, latencies_.size(), at(latencies_, 0.5), at(latencies_, 0.99), at(latencies_, 1),
            double(widths_.size()) / seconds, at(widths_, 0.5),
            (double(std::clock() - beganCpu_) / CLOCKS_PER_SEC) / seconds);
        auto& application = *static_cast<test::TimedApplication*>(qApp);
        using test::EventTime;
        std::printf(
            "%-22s %4zu events     busy    %6.1f ms   p99 %6.1f ms   most %6.1f ms   processor p99 %.1f, most %.1f "
            "ms\n",
            "", application.times.size(), application.at(0.5, &EventTime::wallMs),
            application.at(0.99, &EventTime::wallMs), application.at(1, &EventTime::wallMs),
            application.at(0.99, &EventTime::processorMs), application.at(1, &EventTime::processorMs));
        reportParts();
        std::fflush(stdout);
        begin();
    }

    void begin() {
        latencies_.clear();
        widths_.clear();
        unanswered_.clear();
        parts_ = {};
        static_cast<test::TimedApplication*>(qApp)->times.clear();
        beganMs_ = nowMs();
        beganCpu_ = std::clock();
    }

    const std::shared_ptr<const Frame>& last() const { return desktop_.bridge().lastFrame(); }

  private:
    static double nowMs() { return 1e3 * steadySeconds(); }

    void reportParts() const {
        if (parts_[0].empty())
            return;
        std::printf("%-22s %4zu of scenes' first images", "", parts_[0].size());
        for (std::size_t i = 0; i < kParts.size(); ++i)
            std::printf("   %s %.1f, p99 %.1f", kParts[i], at(parts_[i], 0.5), at(parts_[i], 0.99));
        std::printf(" ms\n");
    }

    /// Takes down the parts of the way of an event that is answered now by the first image of a scene.
    void takeParts(double eventMs, const FrameTimes& times) {
        const std::array<double, kParts.size() + 1> moments{
            eventMs, 1e3 * times.taken, 1e3 * times.begun, 1e3 * times.sampled, 1e3 * times.made, nowMs()};
        for (std::size_t i = 0; i < kParts.size(); ++i)
            parts_[i].push_back(moments[i + 1] - moments[i]);
    }

    /// Prints when an image came, and the parts of the way of the first event that it answers, whose number is `first`.
    void tell(const Frame& frame, std::size_t first) const {
        std::printf("%9.1f ms  %4d px wide, %2llu samples", nowMs() - beganMs_, frame.size.x,
                    (unsigned long long)frame.status.samplesPerPixel);
        for (std::size_t i = 0; i < kParts.size(); ++i)
            std::printf("   %s %.1f", kParts[i], parts_[i][first]);
        std::printf(" ms\n");
    }

    void painted(const Frame& frame) {
        desktop_.window().viewport().repaint();
        widths_.push_back(frame.size.x);
        // Displays have no order: those before the one that is shown were overtaken by it.
        const auto answered = std::find_if(unanswered_.rbegin(), unanswered_.rend(),
                                           [&](const Unanswered& event) { return event.isAnsweredBy(frame); });
        const bool isFirst = frame.revision != std::exchange(shown_, frame.revision) && frame.times.taken > 0;
        const std::size_t first = parts_[0].size();
        for (auto left = unanswered_.rend() - answered; left > 0; --left) {
            if (isFirst)
                takeParts(unanswered_.front().atMs, frame.times);
            latencies_.push_back(nowMs() - unanswered_.front().atMs);
            unanswered_.pop_front();
        }
        if (each_ && parts_[0].size() > first)
            tell(frame, first);
    }

    Desktop& desktop_;
    bool each_;  ///< print each first image of a scene
    std::deque<Unanswered> unanswered_;
    std::vector<double> latencies_, widths_;
    std::array<std::vector<double>, kParts.size()> parts_;
    std::uint64_t shown_ = 0;  ///< revision of the last image
    double beganMs_ = 0;
    std::clock_t beganCpu_ = std::clock();
};

void mouse(QWidget& widget, QEvent::Type type, QPointF place) {
    const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, place, widget.mapToGlobal(place), button, held, {});
    QCoreApplication::sendEvent(&widget, &event);
}

void turn(Desktop& desktop, Stopwatch& watch, double seconds) {
    ui::Viewport& viewport = desktop.window().viewport();
    const QPointF middle = viewport.rect().center();
    mouse(viewport, QEvent::MouseButtonPress, middle);
    watch.begin();
    watch.repeat(seconds, kBetweenEventsMs, [&](int i) {
        mouse(viewport, QEvent::MouseMove, middle + QPointF(200 * std::sin(0.01 * (i + 1)), 0));
    });
    watch.report("turning");
    mouse(viewport, QEvent::MouseButtonRelease, middle);
}

void brighten(Desktop& desktop, Stopwatch& watch, double seconds) {
    auto* slider = test::the<ui::LookPanel>(desktop.window()).findChild<QSlider*>();
    slider->setSliderDown(true);
    watch.begin();
    watch.repeat(seconds, kBetweenEventsMs, [&](int i) { slider->setValue(int(20 * std::sin(0.05 * (i + 1)))); });
    watch.report("brightness");
    slider->setSliderDown(false);
}

/// A node goes round, on the panel of the tissue.
void bend(Desktop& desktop, Stopwatch& watch, double seconds) {
    ui::CurveEditor& editor = test::the<ui::TissuePanel>(desktop.window()).editor();
    const CurvePoint point = editor.points()[editor.points().size() / 2];
    const QPointF place = editor.view().at(double(point.hu), double(point.value));
    mouse(editor, QEvent::MouseButtonPress, place);
    watch.begin();
    watch.repeat(seconds, kBetweenEventsMs, [&](int i) {
        mouse(editor, QEvent::MouseMove, place + 20 * QPointF(std::sin(0.05 * (i + 1)), std::cos(0.05 * (i + 1))));
    });
    watch.report("a node of the tissue");
    mouse(editor, QEvent::MouseButtonRelease, place);
}

void edits(Desktop& desktop, Stopwatch& watch, double seconds) {
    Document& document = desktop.document();
    watch.begin();
    watch.repeat(seconds, 1000, [&](int i) { document.setView(StandardView(i % 2 ? 0 : 1 + i / 2 % 5)); });
    watch.report("a view, at rest");
    watch.begin();
    watch.repeat(seconds, 1000, [&](int i) { document.chooseLook(1 + i % 2); });
    watch.report("a look, at rest");
}

/// Waits until the image has been rendered for two seconds, and returns its samples per pixel.
std::uint64_t rest(Desktop& desktop, const Stopwatch& watch) {
    const auto isRested = [&] {
        const Frame& frame = *watch.last();
        return frame.revision == desktop.document().scene().revision && !frame.coarse && frame.seconds >= 2;
    };
    (void)QTest::qWaitFor(isRested, 60'000);
    return watch.last()->status.samplesPerPixel;
}

/// Waits until an image of the scene at rest, with its mask, has been judged: it is what an edit is laid on.
void awaitJudged(Desktop& desktop, const Stopwatch& watch) {
    const auto isJudged = [&] {
        const Frame& frame = *watch.last();
        return frame.revision == desktop.document().scene().revision && frame.denoisedError && !frame.maskAwaited;
    };
    QTest::qWait(1000);
    (void)QTest::qWaitFor(isJudged, 60'000);
    QTest::qWait(1000);
}

/// Leaves an image by `edit`, comes back by undo and leaves it again by redo, with a rest before each.
void undo(Desktop& desktop, Stopwatch& watch, double seconds, const char* name, const std::function<void()>& edit) {
    constexpr double kSecondsEach = 2;
    Document& document = desktop.document();
    std::uint64_t before = rest(desktop, watch);
    edit();
    std::uint64_t here = rest(desktop, watch);
    watch.begin();
    for (int i = 0; i < std::max(int(seconds / kSecondsEach), 2); ++i) {
        watch.time([&] { i % 2 == 0 ? document.undo() : document.redo(); }, before);
        QTest::qWait(int(1e3 * kSecondsEach));
        before = std::exchange(here, rest(desktop, watch));
    }
    watch.report(name);
}

void undos(Desktop& desktop, Stopwatch& watch, double seconds) {
    Document& document = desktop.document();
    undo(desktop, watch, seconds, "a view, undone", [&] { document.setView(StandardView::left); });
    undo(desktop, watch, seconds, "a look, undone", [&] { document.chooseLook(document.look() == 1 ? 2 : 1); });
    undo(desktop, watch, seconds, "tissue, undone", [&] {
        Look look = document.setup().look;
        look.transferFunction.extinctionPerMm *= 0.9f;
        document.setLook(look);
    });
}

int run(const QString& folder, double seconds, int threads, const QString& only, bool each) {
    QTemporaryDir settings;
    Desktop desktop(*bundledLooks(), makeCpuDevice(threads), settings.filePath("settings.ini"), threads);
    Stopwatch watch(desktop, each);
    desktop.window().show();
    desktop.window().panelToggle("Tissue")->trigger();
    desktop.open(folder);
    if (!QTest::qWaitFor([&] { return watch.last() && !watch.last()->coarse; }, 600'000)) {
        std::printf("no image of %s\n", qPrintable(folder));
        return 1;
    }
    watch.report("loading");
    const QSize view = desktop.window().viewport().sizeInPixels();
    std::printf("%s, view of %d x %d pixels\n", qPrintable(folder), view.width(), view.height());
    using Gesture = void (*)(Desktop&, Stopwatch&, double);
    for (const auto& [name, gesture] : std::initializer_list<std::pair<const char*, Gesture>>{
             {"turn", turn}, {"brightness", brighten}, {"node", bend}, {"edits", edits}, {"undo", undos}})
        if (only.isEmpty() || only == name) {
            awaitJudged(desktop, watch);
            gesture(desktop, watch, seconds);
        }
    return 0;
}

}  // namespace
}  // namespace pdr::app

int main(int argc, char** argv) {
    pdr::app::giveMemoryBack();
    pdr::test::TimedApplication application(argc, argv);
    pdr::ui::applyTheme(application, pdr::ui::ThemeChoice::dark);
    QCommandLineParser parser;
    parser.addPositionalArgument("FOLDER", "a folder with a CT");
    parser.addOption({"seconds", "of each gesture", "S", "10"});
    parser.addOption({"threads", "0: one per core", "N", "0"});
    parser.addOption({"only", "turn, brightness, node, edits or undo", "GESTURE"});
    parser.addOption({"each", "print the parts of the way of each first image of a scene"});
    parser.addHelpOption();
    parser.process(application);
    if (parser.positionalArguments().size() != 1)
        parser.showHelp(2);
    return pdr::app::run(parser.positionalArguments()[0], parser.value("seconds").toDouble(),
                         parser.value("threads").toInt(), parser.value("only"), parser.isSet("each"));
}
