#pragma once
/// Measures how long the window's thread is busy with single events.

#include <QApplication>
#include <QThread>
#include <algorithm>
#include <chrono>
#include <ctime>
#include <string>
#include <vector>

namespace pdr::test {

struct EventTime {
    double processorMs;  ///< time of the window's thread alone, without other programs
    double wallMs;
    std::string what;  ///< the receiver's class and the event's number
};

/// Times each event that the window's thread receives; events that it sends in turn belong to it.
class TimedApplication : public QApplication {
  public:
    using QApplication::QApplication;

    std::vector<EventTime> times;

    bool notify(QObject* receiver, QEvent* event) override {
        if (QThread::currentThread() != thread() || depth_ > 0)  // events of other threads do not count
            return QApplication::notify(receiver, event);
        const std::string what =
            std::string(receiver->metaObject()->className()) + " " + std::to_string(int(event->type()));
        const double processor = processorMs();
        const auto wall = std::chrono::steady_clock::now();
        ++depth_;
        const bool taken = QApplication::notify(receiver, event);
        --depth_;
        const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - wall;
        times.push_back({processorMs() - processor, passed.count(), what});
        return taken;
    }

    /// Returns the time that a fraction `share` of the events does not exceed.
    double at(double share, double EventTime::*time) const {
        std::vector<double> sorted;
        for (const EventTime& one : times)
            sorted.push_back(one.*time);
        std::ranges::sort(sorted);
        return sorted.empty() ? 0 : sorted[std::min(std::size_t(share * double(sorted.size())), sorted.size() - 1)];
    }

    /// Lists the longest events, one per line.
    std::string longest(std::size_t count) const {
        std::vector<EventTime> sorted = times;
        std::ranges::sort(sorted, std::ranges::greater(), &EventTime::processorMs);
        std::string lines;
        for (std::size_t i = 0; i < std::min(count, sorted.size()); ++i)
            lines += std::to_string(sorted[i].processorMs) + " ms: " + sorted[i].what + "\n";
        return lines;
    }

  private:
    static double processorMs() {
        timespec now{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
    }

    int depth_ = 0;
};

}  // namespace pdr::test
