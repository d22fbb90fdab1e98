/// Measures how soon a scan that is being opened lets go after it was cancelled.
///   cancelling PATH... [--trials N]
/// PATH is what the window opens: a folder, an archive or a volume file. Each is listed, and its largest series loaded,
/// without its table, N times (default 20). Each time it is cancelled after another part of what the whole takes.
/// Prints for each step the seconds of the whole, and the milliseconds from the cancellation to the end, on the clock
/// and of the processors: the median, the 95th percentile and the longest. On a busy machine only the latter tell
/// something.

#include <QCommandLineParser>
#include <QCoreApplication>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>
#include <thread>
#include <tuple>
#include <vector>

#include "app/scan/scan_place.h"
#include "app/scan/seen_series.h"
#include "render/base/processor_time.h"

namespace pdr::app {
namespace {

using Clock = std::chrono::steady_clock;
using Step = std::function<void(const Progress&)>;

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// What passes from the cancellation to the end [s]: on the clock, and of the processors.
struct Delay {
    double wall = 0, processor = 0;
};

/// Cancels the step `after` seconds from its begin. None: it ended before.
std::optional<Delay> delayOf(const Step& step, double after) {
    std::atomic<bool> isCancelled = false;
    std::atomic<double> processor = 0;
    const Clock::time_point at =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(after));
    std::jthread user([&](const std::stop_token& ended) {
        while (Clock::now() < at && !ended.stop_requested())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        processor = processorSeconds();
        isCancelled = true;
    });
    step([&](double, std::string_view) { return !isCancelled; });
    if (!isCancelled)
        return std::nullopt;
    return Delay{secondsSince(at), processorSeconds() - processor};
}

/// Prints the median, the 95th percentile and the highest of some times [s], in milliseconds.
void print(std::vector<double> seconds) {
    std::ranges::sort(seconds);
    for (const double share : {0.5, 0.95, 1.0})
        std::printf(" %8.0f", seconds.empty() ? 0 : 1000 * seconds[std::size_t(share * double(seconds.size() - 1))]);
}

void measure(const char* name, const Step& step, int trials) {
    step(noProgress);  // the cache of files
    const Clock::time_point begin = Clock::now();
    step(noProgress);
    const double whole = secondsSince(begin);
    std::vector<double> wall, processor;
    for (int trial = 0; trial < trials; ++trial)
        if (const auto delay = delayOf(step, whole * (trial + 0.5) / trials)) {
            wall.push_back(delay->wall);
            processor.push_back(delay->processor);
        }
    std::printf("  %-6s %8.2f", name, whole);
    print(wall);
    print(processor);
    std::printf("\n");
    std::fflush(stdout);
}

int run(const QStringList& paths, int trials) {
    std::printf("  %-6s %8s %26s %26s\n", "", "whole s", "clock: median p95 longest", "processors, in ms");
    for (const QString& path : paths) {
        std::printf("%s\n", qPrintable(path));
        const std::filesystem::path place = path.toStdString();
        measure(
            "list", [&](const Progress& progress) { std::ignore = scanPlace(place, progress); }, trials);
        const auto scan = scanPlace(place, noProgress);
        if (!scan || scan->series.empty() || !scan->series[0].verdict.loadable())
            continue;
        measure(
            "load", [&](const Progress& progress) { std::ignore = seenSeries(scan->series[0], progress); }, trials);
    }
    return 0;
}

}  // namespace
}  // namespace pdr::app

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addPositionalArgument("PATH", "a folder, an archive or a volume file");
    parser.addOption({"trials", "how often each step is cancelled", "N", "20"});
    parser.addHelpOption();
    parser.process(application);
    if (parser.positionalArguments().isEmpty())
        parser.showHelp(2);
    return pdr::app::run(parser.positionalArguments(), parser.value("trials").toInt());
}
